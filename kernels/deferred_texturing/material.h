// What a material comes to at a pixel, as ranges: glTF's model, and what each shader class adds to it.
#pragma once
#include "kernels/deferred_texturing/filter.h"

namespace assay::deferred_texturing {

struct RangeLayer {
  Range3 base;  // linear
  Range roughness, metallic, occlusion, height;
  Range3 normal;    // tangent space, of any length
  Range3 emissive;  // radiance
};

// Of a material whose class there is. `surface` is the instance.
RangeLayer shaded(std::span<const MaterialRecord> materials, uint32_t material, uint32_t surface, const Filter&,
                  const RangeFootprint&);

}  // namespace assay::deferred_texturing
