// What the shadow lookup promises beyond its bounds: receivers on the planes in a map are wholly lit, by the oracle and
// by the device, and what nothing casts on has the very light that it would have without shadows.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/check/cases.h"
#include "harness/shadow_oracle.h"
#include "kernels/shadow_lookup/oracle.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

Case hard_case(const Kernel& k, const std::string& name) {
  for (const HardCase& hard : k.inputs.hard)
    if (hard.name == name) return hard.make();
  throw std::logic_error("no case " + name);
}

TEST(ShadowLookup, WhatIsInTheMapIsNotInItsOwnShadow) {
  const Kernel& k = kernel_named("shadow_lookup");
  const Case c = hard_case(k, "on_the_plane");
  const Answer expected = shadow_lookup::expected_shares(c);
  for (const Variant& v : k.variants) {
    const Expected& e = expected.at(v.name);
    EXPECT_EQ(e.first.back(), pixels(c)) << v.name << ": undecided receivers";
    EXPECT_EQ(std::ranges::count(values<float>(e.low), 1.0f), static_cast<ptrdiff_t>(pixels(c))) << v.name;
    const auto shares = read<float>(*device(), run_variant(*device(), k, v.name, c), "shares");
    EXPECT_EQ(std::ranges::count(shares, 1.0f), static_cast<ptrdiff_t>(pixels(c))) << v.name;
  }
}

TEST(ShadowLookup, WithoutAPlaneHalfOfItIs) {
  const Kernel& k = kernel_named("shadow_lookup");
  const Case c = hard_case(k, "on_a_plane_of_no_normal");
  const auto shares = read<float>(*device(), run_variant(*device(), k, "pcf_3x3", c), "shares");
  EXPECT_GT(std::ranges::count_if(shares, [](float s) { return s < 0.9f; }), std::ssize(shares) / 2);
}

TEST(ShadowLookup, DithersAreSpreadEvenly) {
  std::vector<int> counts(16);
  for (uint32_t frame = 0; frame < 4; ++frame)
    for (uint32_t y = 0; y < 64; ++y)
      for (uint32_t x = 0; x < 64; ++x) {
        const float dither = shadowing::dither_of(x, y, frame);
        ASSERT_TRUE(dither >= 0 && dither < 1);
        // As Jimenez gives it, in double.
        const double inner = 0.06711056 * (x + 5.588238 * frame) + 0.00583715 * (y + 5.588238 * frame);
        const double outer = 52.9829189 * (inner - std::floor(inner));
        const double off = std::fabs(dither - (outer - std::floor(outer)));
        ASSERT_LT(std::min(off, 1 - off), 1e-5) << x << ", " << y;
        ++counts[static_cast<size_t>(dither * 16)];
      }
  EXPECT_GT(*std::ranges::min_element(counts), 950);
  EXPECT_LT(*std::ranges::max_element(counts), 1100);
}

TEST(ShadowLookup, LightThatNothingHoldsUpIsAsWithoutShadows) {
  const Kernel& k = kernel_named("deferred_lighting");
  const Case c = hard_case(k, "all_lit");
  const auto texels = [&](const char* variant) {
    return device::read(*device(), *run_variant(*device(), k, variant, c).ports.at("radiance"));
  };
  EXPECT_EQ(texels("clustered_shadowed"), texels("clustered"));
  EXPECT_EQ(texels("plain_shadowed"), texels("plain"));
}

}  // namespace
}  // namespace assay::tests
