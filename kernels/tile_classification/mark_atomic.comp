#version 460
// One atomic a pixel, in scan order: the plainest form. The masks are cleared before.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 256) in;
READS(0, uint, features);
UPDATES(1, uint, masks);
PARAMS(ClassifyParams);

void main() {
  const uint pixel = spread_group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  if (pixel >= params.width * params.height) return;
  const uint bits = features[pixel];
  if (bits == 0u) return;
  const uvec2 at = uvec2(pixel % params.width, pixel / params.width);
#if defined(MUTANT_1)  // a lost atomic
  masks[tile_of_pixel(at, params.width)] |= bits;
#elif defined(MUTANT_2)  // tiles a row rounded down
  atomicOr(masks[at.y / kTileSide * (params.width / kTileSide) + at.x / kTileSide], bits);
#else
  atomicOr(masks[tile_of_pixel(at, params.width)], bits);
#endif
}
