#version 460
// Duplicates stay copies: their luma is all that the next frame asks for.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_deblock/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
PARAMS(DeblockParams);
#include "kernels/vrcs_deblock/luma.glsl"

layout(binding = 6) uniform utexture2D radiance;

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef MUTANT_18  // the last column has none
  if (pixel.x + 1 >= int(params.width) || pixel.y >= int(params.height)) return;
#else
  if (pixel.x >= int(params.width) || pixel.y >= int(params.height)) return;
#endif
  store_luma(pixel, texelFetch(radiance, pixel, 0).rg);
}
