// What the fat variant's second 64 bits may hold.
#pragma once
#include "harness/raster/alpha.h"
#include "kernels/visibility/layout.h"

namespace assay::visibility {

// The texel unpacked, as the bound judges it.
struct FatFields {
  float du_dx, dv_dx, du_dy, dv_dy;  // a pixel
  vec3 normal, tangent;              // world, unit length
  float handedness;                  // +1 or -1
};
SHARED_LAYOUT(FatFields, du_dx, dv_dx, du_dy, dv_dy, normal, tangent, handedness);
Bytes unpack_fat(std::span<const std::byte> texels);

// One more alternative: the texel of a pixel that nothing covers, or that of a triangle at pixel x, y.
void append_cleared(Expected&);
void append_fat(Expected&, const raster::Shape&, const std::array<VertexAttributes, 3>&, const SurfaceRecord&,
                uint32_t x, uint32_t y);

}  // namespace assay::visibility
