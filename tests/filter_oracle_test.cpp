// The oracles' texture filter: what an H100 was seen to do is within, and what no device may do is not.
#include "harness/filter_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace assay::tests {
namespace {

constexpr DeviceTraits kEightBits = {};

// Red 0 but for the last column of each level.
Texture column(uint32_t levels) {
  Texture t = {.format = Format::rgba8_srgb, .width = 8, .height = 8, .levels = levels};
  t.bytes.resize(bytes_of(t));
  for (uint32_t l = 0; l < levels; ++l)
    for (uint32_t y = 0; y < height_of(t, l); ++y)
      t.bytes[offset_of(t, l, 0) + (y * width_of(t, l) + width_of(t, l) - 1) * 4] = std::byte{255};
  return t;
}
Interval red_at(const Texture& t, double u, double level) {
  return TextureFilter(t, kEightBits).sampled(0, exactly(u), exactly(0.5), exactly(level))[0];
}

// Red 1 at a weight of 1/16 in the second level, and that at 1/32: 1/512, which an H100 gives as 0, for the product of
// the weights is less than a step of them.
TEST(FilterOracle, WeightsMayBeRoundedAsProducts) {
  const Texture t = column(2);
  const double u = (2.5 + 1.0 / 16) / 4;  // second level: 4 texels, the third's centre and a sixteenth on
  const Interval red = red_at(t, u, 1.0 / 32);
  EXPECT_LE(red.low, 0);
  EXPECT_GE(red.high, 1.0 / 512);
  EXPECT_LT(red.high, 1.0 / 512 + 0x1p-7 + 0x1p-7);  // and a step of the coordinate's weights
}

TEST(FilterOracle, OfEqualTexelsNothingIsRounded) {
  const Texture t = column(2);
  const Interval black = red_at(t, 1.5 / 8, 0);
  EXPECT_LT(black.high, 2 * 3.0 / (255 * 12.92));
  Texture white = t;
  std::ranges::fill(white.bytes, std::byte{255});
  EXPECT_GT(red_at(white, 0.3, 0.5).low, 0.99);  // half a code of sRGB, and a half's roundings
}

}  // namespace
}  // namespace assay::tests
