// The tests' own texture filter: exact where there is nothing to choose, and wide enough where there is.
#include "tests/filter.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "harness/oracle.h"

namespace assay::tests {
namespace {

using glm::dvec2;

constexpr SamplerRoom kExact = {.weight = 0, .level = 0, .value = 0, .value_srgb = 0, .texel_srgb = 0};

scene::Image noise(uint32_t width, uint32_t height, uint64_t seed) {
  scene::Image image = {"noise", width, height, {}};
  Pcg32 rng(seed);
  for (uint32_t i = 0; i < width * height * 4; ++i) image.rgba.push_back(static_cast<uint8_t>(rng.below(256)));
  return image;
}
scene::Scene with(scene::Image image) {
  scene::Scene s = scene::bare();
  s.images = {std::move(image)};
  s.materials[0].base_image = s.materials[0].normal_image = 0;
  return s;
}

TEST(Filter, AConstantImageIsItsValueWhateverTheLevel) {
  const bool passed = rc::check("constant", [] {
    const auto code = *rc::gen::arbitrary<uint8_t>();
    const scene::Scene s = with({"flat", 8, 8, std::vector<uint8_t>(256, code)});
    const double scale = *rc::gen::inRange(0, 100) * 0.01;
    const Footprint f = {{0.3, 0.8}, {scale, 0}, {0, scale}};
    const double value = code / 255.0, linear = srgb_to_linear(value);
    const RangedTexel t = Filter(s).sample(0, false, f);
    RC_ASSERT(t[0].holds(value) && t[0].high - t[0].low <= 2 * (3.0 / 255 + 0.5 / 255 + 2e-5));
    const RangedTexel colour = Filter(s).sample(0, true, f);
    RC_ASSERT(colour[0].holds(linear) && colour[3].holds(value));
  });
  EXPECT_TRUE(passed);
}

TEST(Filter, NoImageIsWhite) {
  const scene::Scene s = scene::bare();
  for (const Range& r : Filter(s).sample(scene::kNone, true, {})) EXPECT_TRUE(r.low == 1 && r.high == 1);
}

TEST(Filter, TexelCentresMagnifiedAreTexels) {
  const scene::Scene s = with(noise(16, 8, 1));
  Filter filter(s, kExact);
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 16; ++x) {
      const Footprint f = {{(x + 0.5) / 16, (y + 0.5) / 8 - 3}, {1e-3, 0}, {0, 1e-3}};
      const double value = s.images[0].rgba[(y * 16 + x) * 4 + 1] / 255.0;
      const RangedTexel t = filter.sample(0, false, f), colour = filter.sample(0, true, f);
      EXPECT_NEAR(t[1].low, value, 1e-4);  // the float coordinate of v = -3 is good to 2^-20 texels
      EXPECT_NEAR(t[1].high, value, 1e-4);
      EXPECT_NEAR(colour[1].low, srgb_to_linear(value), 2e-4);
    }
}

TEST(Filter, LevelsFollowTheLongerAxis) {
  const Range one = level_of_detail({{}, {4.0 / 64, 0}, {0, 1.0 / 32}}, 64, 32, kExact);
  EXPECT_NEAR(one.low, 2, 1e-12);
  EXPECT_NEAR(one.high, 2.5, 1e-12);
  const Range diagonal = level_of_detail({{}, {4.0 / 64, 4.0 / 32}, {0, 0}}, 64, 32, kExact);
  EXPECT_NEAR(diagonal.low, 2, 1e-12);
  EXPECT_NEAR(diagonal.high, 3.5, 1e-12);
  EXPECT_LT(level_of_detail({}, 64, 32, kExact).high, 0);
}

// Mip chains made twice, here and for the frame, agree to the code.
TEST(Filter, TexelsOfEveryLevelHoldWhatTheGatherPacks) {
  for (const auto& [width, height] : {std::pair{16u, 16u}, {8u, 32u}, {7u, 5u}, {1u, 9u}, {30u, 3u}}) {
    const scene::Scene s = with(noise(width, height, width * 100 + height));
    const auto g = gather(s, default_camera(s), {64, 64});
    ASSERT_EQ(g.textures.size(), 2u);
    Filter filter(s, kExact);
    for (const Texture& t : g.textures) {
      const bool srgb = t.format == Format::rgba8_srgb;
      ASSERT_EQ(t.levels, filter.levels(0));
      size_t at = 0;
      for (uint32_t level = 0; level < t.levels; ++level)
        for (uint32_t y = 0; y < std::max(1u, height >> level); ++y)
          for (uint32_t x = 0; x < std::max(1u, width >> level); ++x) {
            const RangedTexel expected = filter.texel(0, srgb, level, x, y);
            for (size_t c = 0; c < 4; ++c, ++at) {
              const double code = static_cast<double>(t.bytes[at]) / 255,
                           v = srgb && c != 3 ? srgb_to_linear(code) : code;
              EXPECT_TRUE(expected[c].holds(v)) << width << "x" << height << " level " << level << " " << x << "," << y;
            }
          }
      EXPECT_EQ(at, t.bytes.size());
    }
  }
}

// A sampler written straight down: any sample whose coordinate, level and weights are within the room is in the range.
double trilinear(Filter& exact, const dvec2& uv, double lambda, uint32_t width, uint32_t height) {
  const auto at_level = [&](uint32_t level) {
    const double w = std::max(1u, width >> level), h = std::max(1u, height >> level);
    const double x = uv.x * w - 0.5, y = uv.y * h - 0.5;
    const auto i = static_cast<int64_t>(std::floor(x)), j = static_cast<int64_t>(std::floor(y));
    double sum = 0;
    for (int64_t dy = 0; dy < 2; ++dy)
      for (int64_t dx = 0; dx < 2; ++dx) {
        const Range t = exact.texel(0, false, level, i + dx, j + dy)[0];
        sum += (t.low + t.high) / 2 * (1 - std::abs(x - static_cast<double>(i + dx))) *
               (1 - std::abs(y - static_cast<double>(j + dy)));
      }
    return sum;
  };
  const auto fine = static_cast<uint32_t>(lambda);
  const double rest = lambda - fine;
  return at_level(fine) * (1 - rest) + (rest > 0 ? at_level(fine + 1) * rest : 0);
}

TEST(Filter, RangesHoldEverySampleThatTheyAllow) {
  const scene::Scene s = with(noise(16, 8, 5));
  const bool passed = rc::check("ranges", [&] {
    Filter filter(s), exact(s, kExact);
    const auto unit = [] { return *rc::gen::inRange(-1000, 1001) * 0.001; };
    Footprint f = {{unit(), unit()}, {unit() * 0.2, unit() * 0.2}, {unit() * 0.2, unit() * 0.2}, {0.003, 0.002}};
    const RangedTexel t = filter.sample(0, false, f);
    const Range lambda = level_of_detail(f, 16, 8, SamplerRoom());
    for (int i = 0; i < 20; ++i) {
      const dvec2 uv = f.uv + f.uv_error * dvec2(unit(), unit());
      const double level = std::clamp(lambda.low + (lambda.high - lambda.low) * std::abs(unit()), 0.0, 4.0);
      RC_ASSERT(t[0].holds(trilinear(exact, uv, level, 16, 8)));
    }
  });
  EXPECT_TRUE(passed);
}

// And not so wide as to hold anything: one level off, or half a texel, is seen.
TEST(Filter, RangesAreNarrowEnoughToTell) {
  const scene::Scene s = with(noise(64, 64, 9));
  Filter filter(s), exact(s, kExact);
  uint32_t shifted = 0, coarser = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    const Footprint f = {{std::fmod(i * 0.618, 1), std::fmod(i * 0.414, 1)}, {0.7 / 64, 0}, {0, 0.7 / 64}};
    const RangedTexel t = filter.sample(0, false, f);
    shifted += !t[0].holds(trilinear(exact, f.uv + 0.5 / 64, 0, 64, 64));
    coarser += !t[0].holds(trilinear(exact, f.uv, 1.5, 64, 64));
    ++all;
  }
  EXPECT_GT(shifted, all / 3);
  EXPECT_GT(coarser, all / 4);
}

}  // namespace
}  // namespace assay::tests
