// Samples of the frame's array textures, as ranges.
#pragma once
#include <span>

#include "harness/filter_oracle.h"
#include "kernels/deferred_texturing/decode.h"

namespace assay::deferred_texturing {

using Range4 = std::array<Range, 4>;

class Filter {
 public:
  Filter(std::span<const Texture> textures, const DeviceTraits&);
  // White where there is no texture.
  Range4 sampled(uint32_t name, const RangeFootprint&) const;

 private:
  struct Slot {
    double width, height;  // texels
    TextureFilter texture;
  };
  std::vector<Slot> slots_;
};

}  // namespace assay::deferred_texturing
