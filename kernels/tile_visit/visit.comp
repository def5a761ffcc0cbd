#version 460
// What any shader does that is dispatched over a tile workload: find its tile and its pixels, here to count that it came.
// The counts are cleared before.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_visit/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 64) in;
READS(0, uint, workload_tiles);
READS(1, WorkloadCount, workload_counts);
UPDATES(2, uint, visits);
PARAMS(VisitParams);
ROW();

void main() {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint tiles = tile_count(extent);
#ifdef MUTANT_1  // the second plane of a long list starts over
  const uint entry = gl_WorkGroupID.y;
#else
  const uint entry = workload_entry();
#endif
#ifndef MUTANT_2  // groups left over work on what lies behind the list
  if (entry >= min(workload_counts[row].tiles, tiles)) return;
#endif
#ifdef MUTANT_3  // always the first workload's list
  const uint tile = workload_tiles[entry];
#else
  const uint tile = workload_tiles[row * tiles + entry];
#endif
#ifndef MUTANT_4  // a tile that there is not is visited all the same, wherever its number wraps to
  if (tile >= tiles) return;
#endif
  // The tile's groups share its pixels, however many they are.
  const uint lane = gl_WorkGroupID.x * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
#ifdef MUTANT_5  // each group works on all that follows
  for (uint i = lane; i < kTileSide * kTileSide; i += gl_WorkGroupSize.x) {
#else
  for (uint i = lane; i < kTileSide * kTileSide; i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
#endif
    const uvec2 at = pixel_of_tile(tile, i, extent.x);
#ifdef MUTANT_6  // one column too many
    if (at.x <= extent.x && at.y < extent.y) {
#else
    if (on_screen(at, extent)) {
#endif
      atomicAdd(visits[at.y * extent.x + at.x], 1u << 4u * row);  // pixels are this row's own, but rows may overlap
    }
  }
}
