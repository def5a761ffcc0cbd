// Isotropic trilinear samples of an array texture, repeated at its sides: every answer that Vulkan permits, as
// intervals. Host only.
#pragma once
#include <map>

#include "harness/block_decoder.h"
#include "harness/bounded.h"

namespace assay {

using Intervals4 = std::array<Interval, 4>;

// Derivatives of texture coordinates in texels of the first level, a pixel.
struct TexelDerivatives {
  Interval u_dx, v_dx, u_dy, v_dy;
};

class TextureFilter {
 public:
  // Of rgba8 or blocks of 4x4, which must outlive it; other formats: std::logic_error.
  TextureFilter(const Texture&, const DeviceTraits&);

  // The level that textureGrad may take: from the largest derivative to sqrt(2) times a pixel's sum (Vulkan, Scale
  // Factor Operation), and its rounding.
  Interval level_of(const TexelDerivatives&) const;
  // The level that textureLod may take, of a level that was worked out.
  Interval level_of(Interval level) const;
  // At a level out of an interval that one of these made. A layer past the end is the last.
  Intervals4 sampled(uint32_t layer, Interval u, Interval v, Interval level) const;

 private:
  struct Level {                  // of one layer
    const std::byte *low, *high;  // codes of 8 bits, four a texel: the same but where blocks may be decoded to either
    uint32_t width, height;
    bool is_srgb;
    Interval texel(int64_t x, int64_t y, uint32_t channel) const;  // repeated
  };
  Interval on_levels(double low, double high) const;
  Level level(uint32_t layer, uint32_t level) const;
  Intervals4 whole(const Level&) const;
  struct Filtered {
    Intervals4 value, texels;  // and the range of the texels that it is made of
  };
  Filtered bilinear(const Level&, Interval x, Interval y) const;

  const Texture* texture_;
  DeviceTraits device_;
  mutable std::map<std::pair<uint32_t, uint32_t>, DecodedTexels> decoded_;  // layer, level; as they are asked for
  mutable std::map<const std::byte*, Intervals4> whole_;
};

}  // namespace assay
