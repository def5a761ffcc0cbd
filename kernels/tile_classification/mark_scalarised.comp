#version 460
// One atomic a subgroup and tile, from pixels in scan order, so that a subgroup may straddle tiles as it does in any pass
// that ORs its features into the masks by the way. The masks are cleared before.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 256) in;
READS(0, uint, features);
UPDATES(1, uint, masks);
PARAMS(ClassifyParams);
#define TILE_MASKS masks
#include "harness/glsl/tile_or.glsl"

void main() {
  const uint pixel = spread_group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
  const bool live = pixel < params.width * params.height;
  const uint width = max(params.width, 1u);
  or_into_tile(tile_of_pixel(uvec2(pixel % width, pixel / width), width), live ? features[pixel] : 0u);
}
