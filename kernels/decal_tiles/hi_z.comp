#version 460
// A thread a tile: the cells that overlap it on the screen, in the slices from its nearest to its farthest depth. Those
// of a group are counted first, so that it asks for a place in the list once.
// Loop turns of an invocation: slices by cells that overlap the tile, 32 * 16 * 16 at most.
#include "kernels/decal_tiles/common.glsl"

layout(local_size_x = 64) in;
READS(4, vec2, ranges);  // of reversed depth, x: the least, the farthest; y: the greatest, the nearest

shared uint listed, first_of_group;

bool may_have_decals(uint tile) {
  const vec2 range = ranges[params.first_range + tile];
#ifdef MUTANT_2  // tiles without a surface too
  const bool has_surface = true;
#else
  const bool has_surface = takes_decals(range.y) || floatBitsToUint(range.y) == 0x7f800000u;
#endif
  if (!has_surface) return false;
  const uvec2 first = first_of_decal_tile(tile, params.width);
  const uvec2 last = min(first + (kDecalTileSide - 1u), uvec2(params.width, params.height) - 1u);
  const uvec2 from = column_row_of(params.grid, first);
#ifdef MUTANT_3  // a tile lies in one cell
  const uvec2 to = from;
#else
  const uvec2 to = column_row_of(params.grid, last);
#endif
#ifdef MUTANT_4  // the slice of the nearest pixel is left out
  const uint nearest = slice_of(params.grid, range.y) + 1u;
#else
  const uint nearest = slice_of(params.grid, range.y);
#endif
#ifdef MUTANT_5  // the slice of the farthest pixel is left out
  for (uint slice = nearest; slice < slice_of(params.grid, range.x); ++slice)
#else
  const uint farthest = slice_of(params.grid, range.x);
  for (uint slice = nearest; slice <= farthest; ++slice)
#endif
    for (uint y = from.y; y <= to.y; ++y)
      for (uint x = from.x; x <= to.x; ++x)
        if (lists_decal((slice * params.grid.rows + y) * params.grid.columns + x)) return true;
  return false;
}

void main() {
  const uint thread = gl_LocalInvocationID.x, tile = spread_group() * 64u + thread;
  if (thread == 0u) listed = 0u;
  barrier();
  const bool is_listed = tile < all_tiles() && may_have_decals(tile);
  uint at = 0u;
  if (is_listed) at = atomicAdd(listed, 1u);
  barrier();
  if (thread == 0u) first_of_group = atomicAdd(count[0], listed);
  barrier();
#ifdef MUTANT_6  // each group from the list's start on
  if (is_listed) tiles[at] = tile;
#else
  if (is_listed) tiles[first_of_group + at] = tile;
#endif
}
