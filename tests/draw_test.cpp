// Draw passes: which way faces look, indirect and counted draws, depth and blending, what is left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "harness/oracle.h"
#include "tests/lowered.h"
#include "tests/planted/device_draw/layout.h"

namespace assay::tests {
namespace {

using device_draw::DrawParams;
using device_draw::kFrontBit;

constexpr uint32_t kSide = 16;  // pixels of the picture
constexpr uint32_t kBackground = 9;

// Two triangles in the world, y up, seen along -z from the origin: the upper one counter-clockwise, the lower
// clockwise. At z = -1 the picture spans -1..1. The upper one is as wide as the picture at y = 0.5 and ends in a tip at
// y = 1.
Case triangles(DrawParams params) {
  Case c = {.name = "triangles"};
  c.extent = {kSide, kSide};
  c.set_params(params);
  c.set_input("positions", std::vector<vec3>{{-1, 0.5f, -1},
                                             {1, 0.5f, -1},
                                             {0, 1, -1},  // counter-clockwise
                                             {-1, -1, -1},
                                             {0, -0.5f, -1},
                                             {1, -1, -1}});  // clockwise
  c.set_input("indices", std::vector<uint32_t>{0, 1, 2, 3, 4, 5});
  c.set_input("commands", std::vector<DrawCommand>{{3, 1, 0, 0, 1}, {3, 1, 3, 0, 2}, {3, 1, 0, 3, 3}});
  c.set_input("limit", std::vector<uint32_t>{1});
  c.set_input("fragments", std::vector<uint32_t>{0});
  return c;
}

struct Picture {
  std::vector<uint32_t> texels;
  uint64_t count(uint32_t value) const { return static_cast<uint64_t>(std::ranges::count(texels, value)); }
  uint64_t count_in_rows(uint32_t value, size_t from, size_t to) const {
    const std::span rows(texels.data() + from * kSide, (to - from) * kSide);
    return static_cast<uint64_t>(std::ranges::count(rows, value));
  }
};
Picture colours(const std::string& variant, const Case& c) {
  const Ran r = run_variant(*device(), planted("device_draw"), variant, c);
  return {read<uint32_t>(*device(), r, "colour")};
}

TEST(Draw, CounterClockwiseInTheWorldIsTheFront) {
  const Picture p = colours("both", triangles({0, 2, 0}));
  EXPECT_GT(p.count(1 | kFrontBit), 0u);
  EXPECT_EQ(p.count(1), 0u);
  EXPECT_GT(p.count(2), 0u);
  EXPECT_EQ(p.count(2 | kFrontBit), 0u);
}

TEST(Draw, TheWorldsUpIsThePicturesUp) {
  const Picture p = colours("both", triangles({0, 2, 0}));
  EXPECT_EQ(p.count(1 | kFrontBit), p.count_in_rows(1 | kFrontBit, 0, kSide / 4));
  EXPECT_EQ(p.count(2), p.count_in_rows(2, 3 * kSide / 4, kSide));
  EXPECT_GT(p.count_in_rows(1 | kFrontBit, 3, 4), p.count_in_rows(1 | kFrontBit, 0, 1)) << "the tip is above";
}

TEST(Draw, CullsBacksOrFronts) {
  const Case c = triangles({0, 2, 0});
  const Picture both = colours("both", c), back = colours("back", c), front = colours("front", c);
  EXPECT_EQ(back.count(1 | kFrontBit), both.count(1 | kFrontBit));
  EXPECT_EQ(back.count(2), 0u);
  EXPECT_EQ(front.count(1 | kFrontBit), 0u);
  EXPECT_EQ(front.count(2), both.count(2));
}

TEST(Draw, BeginsAtTheFirstCommand) {
  const Picture p = colours("both", triangles({1, 2, 0}));
  EXPECT_EQ(p.count(1 | kFrontBit), 0u);
  EXPECT_GT(p.count(2) + p.count(3), 0u) << "instances 2 and 3, the latter by its vertex offset";
}

TEST(Draw, TheDevicesCountBoundsTheDraw) {
  if (!device::missing(device::info(*device()), variant_of(planted("device_draw"), "counted")).empty()) GTEST_SKIP();
  const Picture p = colours("counted", triangles({0, 0, 3}));
  EXPECT_GT(p.count(1 | kFrontBit), 0u);
  EXPECT_EQ(p.count(2) + p.count(3), 0u);
}

TEST(Draw, DirectlyWithAndWithoutIndices) {
  for (const char* variant : {"indexed", "plain"}) {
    const Picture p = colours(variant, triangles({3, 3, 0}));
    EXPECT_GT(p.count(0), 0u) << variant;
    EXPECT_EQ(p.count(0) + p.count(kBackground), uint64_t{kSide} * kSide) << variant;
  }
}

TEST(Draw, DepthIsNearOverDistance) {
  const Ran r = run_variant(*device(), planted("device_draw"), "both", triangles({0, 1, 0}));
  const auto depth = read<float>(*device(), r, "depth");
  const auto texels = read<uint32_t>(*device(), r, "colour");
  for (size_t i = 0; i < depth.size(); ++i) EXPECT_EQ(depth[i], texels[i] == kBackground ? 0.0f : 0.25f);
}

TEST(Draw, DepthIsComparedAndWrittenAsDescribed) {
  const Case c = triangles({0, 1, 0});  // at depth 0.25, the target is cleared to 0.5
  EXPECT_GT(colours("less", c).count(1 | kFrontBit), 0u);
  EXPECT_EQ(colours("greater", c).count(1 | kFrontBit), 0u);
  const Ran r = run_variant(*device(), planted("device_draw"), "unwritten", c);
  for (const float depth : read<float>(*device(), r, "depth")) EXPECT_EQ(depth, 0.5f);
}

TEST(Draw, FragmentsWriteBuffers) {
  const Ran r = run_variant(*device(), planted("device_draw"), "back", triangles({0, 2, 0}));
  const Picture p = {read<uint32_t>(*device(), r, "colour")};
  EXPECT_EQ(read<uint32_t>(*device(), r, "fragments")[0], p.count(1 | kFrontBit));
}

TEST(Draw, WithNothingToDrawItOnlyClears) {
  EXPECT_EQ(colours("both", triangles({0, 0, 0})).count(kBackground), uint64_t{kSide} * kSide);
  EXPECT_EQ(colours("unclear", triangles({0, 0, 0})).count(kPoison), uint64_t{kSide} * kSide);
  const Ran r = run_variant(*device(), planted("device_draw"), "unclear", triangles({0, 0, 0}));
  EXPECT_EQ(r.commands.size(), 2u) << "the two timestamps alone";
}

// The light is (1, 2, 4) with alpha 1/4, over a target cleared to red 0.5.
TEST(Draw, Blends) {
  for (const auto& [variant, red] : {std::pair("over", 0.625), std::pair("add", 1.5)}) {
    const Ran r = run_variant(*device(), planted("device_draw"), variant, triangles({0, 3, 0}));
    const auto halves = read<uint16_t>(*device(), r, "light");
    const double expected = red;
    const uint32_t bits = halves[size_t{4} * (3 * kSide + kSide / 2)];
    const double got = std::ldexp(1 + (bits & 0x3ff) / 1024.0, int(bits >> 10) - 15);
    EXPECT_EQ(got, expected) << variant;
  }
}

TEST(Draw, UsesAreNamedWithTheirScopes) {
  const Ran r = run_variant(*device(), planted("device_draw"), "both", triangles({0, 2, 0}));
  std::map<std::string, uint32_t> scopes;
  for (const device::Use& u : r.commands[1].uses) scopes[u.port] |= u.scope;
  EXPECT_EQ(scopes["commands"], device::kIndirect);
  EXPECT_EQ(scopes["indices"], device::kGraphics);
  EXPECT_EQ(scopes["positions"], device::kGraphics);
  EXPECT_EQ(scopes["fragments"], device::kGraphics);
  EXPECT_EQ(scopes["colour"], device::kAttachment);
  EXPECT_EQ(scopes["depth"], device::kAttachment);
}

}  // namespace
}  // namespace assay::tests
