#version 460
// A thread a tile: onto the list of tiles with edges or onto the other; one atomic a group and list. The counts are
// cleared before.
#include "harness/glsl/ports.glsl"
#include "kernels/edge_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 256) in;
READS(0, uvec2, edge_mask);
UPDATES(1, uint, tile_counts);
WRITES(2, uint, edge_tiles);
WRITES(3, uint, plain_tiles);
PARAMS(EdgeParams);

shared uint tiles_here[2];
shared uint first_entry[2];

void main() {
  const uint tiles = ceil_div(params.width, kEdgeTileSide) * ceil_div(params.height, kEdgeTileSide);
  const uint tile = gl_GlobalInvocationID.x;
  const uint thread = gl_LocalInvocationID.x;
  if (thread < 2u) tiles_here[thread] = 0u;
  barrier();
  uint list = kPlainTiles;
  uint slot = 0u;
  if (tile < tiles) {
    if (edge_mask[tile] != uvec2(0u)) list = kEdgeTiles;
#ifdef MUTANT_12  // a lost atomic
    slot = tiles_here[list]++;
#else
    slot = atomicAdd(tiles_here[list], 1u);
#endif
  }
#ifndef MUTANT_13  // the barrier dropped: the run is reserved before the higher subgroups have counted
  barrier();
#endif
  if (thread < 2u) first_entry[thread] = atomicAdd(tile_counts[thread], tiles_here[thread]);
  barrier();
  if (tile >= tiles) return;
  if (list == kEdgeTiles)
    edge_tiles[first_entry[list] + slot] = tile;
  else
    plain_tiles[first_entry[list] + slot] = tile;
}
