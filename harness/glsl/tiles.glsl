// Screen tiles of kTileSide x kTileSide pixels, numbered row by row, and the dispatches that run over lists of them.
#ifndef HARNESS_GLSL_TILES
#define HARNESS_GLSL_TILES
#include "harness/formats/workloads.h"

uint ceil_div(uint a, uint b) { return a / b + uint(a % b != 0u); }
uint tiles_across(uint width) { return ceil_div(width, kTileSide); }
uint tile_count(uvec2 extent) { return tiles_across(extent.x) * tiles_across(extent.y); }

uint tile_of_pixel(uvec2 pixel, uint width) {
  return pixel.y / kTileSide * tiles_across(width) + pixel.x / kTileSide;
}

// The i-th pixel of a tile, row by row, i in 0..1023. In a partial tile it may lie outside the screen.
uvec2 pixel_of_tile(uint tile, uint i, uint width) {
  const uint across = tiles_across(width);
  return uvec2(tile % across, tile / across) * kTileSide + uvec2(i % kTileSide, i / kTileSide);
}
bool on_screen(uvec2 pixel, uvec2 extent) { return pixel.x < extent.x && pixel.y < extent.y; }

// n groups over two dimensions of at most kMaxGroups each, in equal rows: fewer than .y groups are left over.
uvec2 spread(uint n) {
  const uint rows = ceil_div(n, kMaxGroups);
  return rows == 0u ? uvec2(0u) : uvec2(ceil_div(n, rows), rows);
}
// This group's number in a dispatch spread over x and y (spread_groups of harness/groups.h). May exceed the number
// wanted: compare before use.
uint spread_group() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

// In an indirect dispatch of a tile workload, DispatchArgs{groups a tile, spread(tiles)}: which entry of the workload's
// list this group works on. Turn the group away unless the entry is below workload_counts[row].tiles; its tile is then
// workload_tiles[row * tile_count + entry], and gl_WorkGroupID.x says which of the tile's groups it is.
uint workload_entry() { return gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y; }
#endif
