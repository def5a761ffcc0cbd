// Isotropic trilinear samples of array textures: every answer that Vulkan permits, as ranges.
#pragma once
#include <map>
#include <span>

#include "kernels/deferred_texturing/decode.h"

namespace assay::deferred_texturing {

using Range4 = std::array<Range, 4>;

class Filter {
 public:
  Filter(std::span<const Texture> textures, const DeviceTraits& device) : textures_(textures), device_(device) {}
  // White where there is no texture.
  Range4 sampled(uint32_t name, const RangeFootprint&) const;

 private:
  struct Level {  // of one layer
    const std::byte* texels;
    uint32_t width, height;
    bool is_srgb;
    Range texel(int64_t x, int64_t y, uint32_t channel) const;  // repeated
  };
  static Level level_of(const Texture&, uint32_t layer, uint32_t level);
  Range4 whole(const Level&) const;
  Range4 bilinear(const Level&, Range x, Range y) const;

  std::span<const Texture> textures_;
  DeviceTraits device_;
  mutable std::map<const std::byte*, Range4> whole_;
};

}  // namespace assay::deferred_texturing
