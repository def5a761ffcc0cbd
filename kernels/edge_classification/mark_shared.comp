#version 460
// A group a tile, the mask gathered by shared atomics, and the tile appended at once: the form of Pettineo 2016.
// The counts are cleared before.
#include "kernels/edge_classification/common.glsl"

layout(local_size_x = 64) in;
WRITES(2, uvec2, edge_mask);
UPDATES(3, uint, tile_counts);
WRITES(4, uint, edge_tiles);
WRITES(5, uint, plain_tiles);

shared uint edges[2];

void main() {
  const uint tile = spread_group();
  if (tile >= edge_tile_count()) return;  // the whole group
  const uint i = gl_LocalInvocationID.x;
  if (i < 2u) edges[i] = 0u;
  barrier();
#ifdef MUTANT_6  // a lost atomic
  if (is_edge(tile, i)) edges[i / 32u] |= 1u << i % 32u;
#else
  if (is_edge(tile, i)) atomicOr(edges[i / 32u], 1u << i % 32u);
#endif
#ifndef MUTANT_7  // the barrier dropped: stored before the higher subgroups have joined
  barrier();
#endif
  if (i != 0u) return;
  edge_mask[tile] = uvec2(edges[0], edges[1]);
  if ((edges[0] | edges[1]) != 0u)
    edge_tiles[atomicAdd(tile_counts[kEdgeTiles], 1u)] = tile;
  else
    plain_tiles[atomicAdd(tile_counts[kPlainTiles], 1u)] = tile;
}
