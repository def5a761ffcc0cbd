#version 460
// A group a tile, a thread a pixel: the cell that the pixel is in. No loops but the slice's.
#include "kernels/decal_tiles/common.glsl"

layout(local_size_x = kDecalTileSide, local_size_y = kDecalTileSide) in;
layout(binding = 5) uniform texture2D depth;

shared uint pixels;  // that are in cells that list decals

bool has_decals(uvec2 pixel) {
  if (pixel.x >= params.width || pixel.y >= params.height) return false;
  const float d = texelFetch(depth, ivec2(pixel), 0).r;
#ifdef MUTANT_7  // the background takes decals
  return lists_decal(cell_of(params.grid, pixel, d));
#else
  return takes_decals(d) && lists_decal(cell_of(params.grid, pixel, d));
#endif
}

void main() {
  const uint tile = spread_group();
  if (tile >= all_tiles()) return;  // the whole group
  const bool is_first = gl_LocalInvocationIndex == 0u;
  if (is_first) pixels = 0u;
  barrier();
  if (has_decals(first_of_decal_tile(tile, params.width) + gl_LocalInvocationID.xy)) atomicAdd(pixels, 1u);
#ifndef MUTANT_8  // the barrier dropped: what higher subgroups have yet to say is missing
  barrier();
#endif
#ifdef MUTANT_9  // one pixel is none
  if (is_first && pixels > 1u) tiles[atomicAdd(count[0], 1u)] = tile;
#else
  if (is_first && pixels != 0u) tiles[atomicAdd(count[0], 1u)] = tile;
#endif
}
