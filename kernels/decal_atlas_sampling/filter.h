// Isotropic trilinear samples of the atlas: every answer that Vulkan permits, as intervals.
#pragma once
#include <map>

#include "harness/bounded.h"

namespace assay::decal_atlas_sampling {

using Intervals4 = std::array<Interval, 4>;

// a (1 - t) + b t or a + (b - a) t: extremes at the corners, three roundings of terms no larger than |a| + |b|.
Interval mixed(Interval a, Interval b, Interval t);
// A number of terms summed in any order, fused or not.
Interval sum_of(std::initializer_list<Interval> terms);

// Derivatives of texture coordinates in texels of the first level, a pixel.
struct TexelDerivatives {
  Interval u_dx, v_dx, u_dy, v_dy;
};
Interval absolute(Interval);

class AtlasFilter {
 public:
  // An array texture of rgba8_unorm or rgba8_srgb.
  AtlasFilter(const Texture& texture, const DeviceTraits& device) : texture_(texture), device_(device) {}

  // The level that textureGrad may take: from the largest derivative to sqrt(2) times a pixel's sum (Vulkan, Scale
  // Factor Operation), and its rounding.
  Interval level_of(const TexelDerivatives&) const;
  // The level that textureLod may take, of a level that was worked out.
  Interval level_of(Interval level) const;
  // At a level out of an interval that one of these made.
  Intervals4 sampled(uint32_t page, Interval u, Interval v, Interval level) const;

 private:
  struct Level {  // of one page
    const std::byte* texels;
    uint32_t width, height;
    bool is_srgb;
    Interval texel(int64_t x, int64_t y, uint32_t channel) const;  // repeated
  };
  Interval on_levels(double low, double high) const;
  Level level(uint32_t page, uint32_t level) const;
  Intervals4 whole(const Level&) const;
  Intervals4 bilinear(const Level&, Interval x, Interval y) const;

  const Texture& texture_;
  DeviceTraits device_;
  mutable std::map<const std::byte*, Intervals4> whole_;
};

}  // namespace assay::decal_atlas_sampling
