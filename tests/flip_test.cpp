// FLIP against pairs whose values are known, and where the answer is plain.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "harness/image/flip.h"

namespace assay::tests {
namespace {

using namespace image;
namespace fs = std::filesystem;

const fs::path kPairs = "../shared/data/flip";

// Values of the authors' own tool (v1.6), kept beside the pairs.
void expect_values(const Flip& f, double mean, const fs::path& map) {
  EXPECT_NEAR(f.mean, mean, 1e-4);
  const Rgba8 known = read_png(map);
  ASSERT_EQ(known.texels.size(), f.map.size() * 4);
  size_t off = 0;
  for (size_t i = 0; i < f.map.size(); ++i)
    off += std::abs(std::lround(f.map[i] * 255) - long{known.texels[4 * i]}) > 1;
  EXPECT_EQ(off, 0u) << "of " << f.map.size() << " pixels, over a code";
}

TEST(Flip, OfPicturesIsWhatIsKnown) {
  if (!fs::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  const fs::path pair = kPairs / "ldr_tree";
  expect_values(flip(linear_of(read_png(pair / "reference.png")), linear_of(read_png(pair / "test.png"))), 0.133276,
                pair / "error_map_gray.png");
}

TEST(Flip, OfRadianceIsWhatIsKnown) {
  if (!fs::exists(kPairs)) GTEST_SKIP() << kPairs << " is not there";
  const fs::path pair = kPairs / "hdr_sponza";
  const Flip f = flip_hdr(linear_of(read_exr(pair / "reference.exr")), linear_of(read_exr(pair / "test.exr")));
  EXPECT_EQ(f.exposures, 6u);
  EXPECT_NEAR(f.start, 0.1651, 1e-4);
  EXPECT_NEAR(f.stop, 5.9493, 1e-4);
  expect_values(f, 0.552506, pair / "error_map_gray.png");
}

Pixels of(uint32_t width, uint32_t height, const glm::vec3& c) {
  return {width, height, std::vector<glm::vec3>(size_t{width} * height, c)};
}

TEST(Flip, OfAPictureWithItselfIsNothing) {
  Pixels p = of(33, 20, {0.2f, 0.5f, 0.1f});
  p.rgb[77] = {1, 0, 0};
  EXPECT_EQ(flip(p, p).mean, 0);
  EXPECT_EQ(flip_hdr(p, p).mean, 0);
  EXPECT_EQ(psnr(p, p), INFINITY);
}

// The two colours that are farthest apart: the scale's end.
TEST(Flip, OfGreenWithBlueIsOne) {
  for (const float v : flip(of(9, 7, {0, 1, 0}), of(9, 7, {0, 0, 1})).map) EXPECT_NEAR(v, 1, 1e-6);
}

TEST(Flip, ABlurredEdgeIsSeenWhereItIs) {
  Pixels sharp = of(64, 16, glm::vec3(0.2f)), soft = sharp;
  for (uint32_t i = 0; i < 64 * 16; ++i) {
    const uint32_t x = i % 64;
    sharp.rgb[i] = glm::vec3(x < 32 ? 0.2f : 0.6f);
    soft.rgb[i] = glm::vec3(x < 28 ? 0.2f : x < 36 ? 0.4f : 0.6f);
  }
  const Flip f = flip(sharp, soft);
  EXPECT_GT(f.map[8 * 64 + 32], 0.1);
  EXPECT_LT(f.map[8 * 64 + 2], 1e-6);
}

TEST(Flip, WhatCannotBeComparedIsRefused) {
  Pixels p = of(4, 4, glm::vec3(1)), q = p;
  EXPECT_THROW(flip(p, of(4, 3, glm::vec3(1))), std::runtime_error);
  q.rgb[5].y = NAN;
  EXPECT_THROW(flip(p, q), std::runtime_error);
  EXPECT_THROW(flip_hdr(q, p), std::runtime_error);
  EXPECT_THROW(psnr(p, q), std::runtime_error);
  EXPECT_THROW(linear_of(Layers{1, 1, {{"depth", Sample::float32, {1}, {}}}}), std::runtime_error);
}

TEST(Flip, PsnrIsOfTheMeanSquare) {
  EXPECT_NEAR(psnr(of(8, 8, glm::vec3(2)), of(8, 8, glm::vec3(1.8f))), 20, 1e-5);
  Rgba8 a = {2, 1, {10, 10, 10, 255, 20, 20, 20, 255}}, b = a;
  b.texels[0] = 16, b.texels[3] = 0;
  EXPECT_NEAR(psnr(a, b), 10 * std::log10(255.0 * 255 * 6 / 36), 1e-12);
}

}  // namespace
}  // namespace assay::tests
