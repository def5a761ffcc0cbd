#include "kernels/hi_z/oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/oracle.h"

namespace assay::hi_z {

Extent size_of_level(Extent image, uint32_t level) { return tiles_of(image, 1u << level); }

uint32_t level_count(Extent image) {
  uint32_t level = 1;
  while (std::max(image.width, image.height) > 1u << level) ++level;
  return level;
}

uint64_t texels(const Case& c) {
  uint64_t all = 0;
  for (uint32_t level = 1; level <= level_count(c.extent); ++level) all += pixel_count(size_of_level(c.extent, level));
  return all;
}

namespace {

// No surface: the far background, and whatever is not a depth.
float depth_of(float d) { return d > 0 ? d : 0.0f; }

// Of pixels, not of texels: each level anew from the image.
std::vector<vec2> level_of(Extent image, std::span<const float> depth, uint32_t level) {
  const Extent size = size_of_level(image, level);
  std::vector<vec2> texels(pixel_count(size), vec2(std::numeric_limits<float>::infinity(), 0));
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const float d = depth_of(depth[size_t{y} * image.width + x]);
      vec2& texel = texels[size_t{y >> level} * size.width + (x >> level)];
      texel = vec2(std::min(texel.x, d), std::max(texel.y, d));
    }
  return texels;
}

}  // namespace

Answer pyramid(const Case& c) {
  std::vector<vec2> all;
  for (uint32_t level = 1; level <= level_count(c.extent); ++level) {
    const auto texels = level_of(c.extent, c.input<float>("depth"), level);
    all.insert(all.end(), texels.begin(), texels.end());
  }
  return {{"ranges", expect_all(all)}};
}

}  // namespace assay::hi_z
