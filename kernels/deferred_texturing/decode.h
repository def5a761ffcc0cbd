// A pixel's interpolated attributes and where its textures are sampled, as ranges, from the bytes that the shaders
// read.
#pragma once
#include "harness/formats/attributes.h"
#include "harness/interpolation_oracle.h"
#include "kernels/deferred_texturing/layout.h"
#include "kernels/deferred_texturing/range.h"

namespace assay::deferred_texturing {

struct PixelAttributes {
  Range weight_1, weight_2;                                  // barycentrics of the second and third vertex
  Range weight_1_dx, weight_2_dx, weight_1_dy, weight_2_dy;  // a pixel
  Range3 normal, tangent;                                    // world
  bool left_handed = false, front_facing = false;
  bool determined = true;  // false: float arithmetic may find any weights in the triangle, and anything of the rest
};
PixelAttributes decoded(uint32_t barycentrics, uvec2 derivatives, uvec2 tangent_frame);
// What the default formula of attribute_interpolation may find, before anything is packed.
PixelAttributes interpolated(const interpolation::Triangle&, const SurfaceRecord&, bool flipped,
                             const interpolation::Few<const VertexAttributes*, 3>&);

// Texture coordinates and their derivatives, a pixel.
struct RangeFootprint {
  Range u, v, u_dx, v_dx, u_dy, v_dy;
};
// What is beyond kLargestUv becomes 0, a derivative beyond kLargestGradient becomes that.
RangeFootprint usable(const RangeFootprint&);
RangeFootprint footprint_of(const std::array<vec2, 3>& uv, const PixelAttributes&);
RangeFootprint scaled(const RangeFootprint&, float by);

}  // namespace assay::deferred_texturing
