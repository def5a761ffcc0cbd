#version 460
// Reads back what was packed, as every consumer does.
#include "harness/glsl/attributes.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/attribute_interpolation/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(constant_id = 0) const uint LAYOUT = kAttributesPacked;
READS(6, uint, barycentrics);
READS(7, uvec2, derivatives);
READS(8, uvec2, tangent_frame);
WRITES(9, DecodedAttributes, decoded);
PARAMS(AttributeParams);

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const uint at = pixel.y * params.width + pixel.x;
  const SurfaceAttributes a = decode_attributes_as(LAYOUT, barycentrics[at], derivatives[at], tangent_frame[at]);
  decoded[at] = DecodedAttributes(a.barycentrics, a.d_dx, a.d_dy, a.normal, a.tangent, a.handedness,
                                  a.front_facing ? 1u : 0u);
}
