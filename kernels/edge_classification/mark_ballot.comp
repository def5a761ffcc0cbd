#version 460
// Two tiles a group of 128 threads, which subgroups of any width from 4 to 128 fill exactly: each votes its pixels by a
// ballot, and one thread a tile joins the votes to 64 bits.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "kernels/edge_classification/common.glsl"

layout(local_size_x = 128) in;
WRITES(2, uvec2, edge_mask);

shared uint pieces[32];  // at width 4: 128 / 4

void main() {
  const uint first_tile = spread_group() * 2u;
  const uint tiles = edge_tile_count();
  // Numbered by subgroup, so that the votes' order is the pixels', however lanes map to invocations.
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
  const uint tile = first_tile + lane / 64u;
  const uvec4 votes = subgroupBallot(tile < tiles && is_edge(tile, lane % 64u));
  const uint piece_bits = min(gl_SubgroupSize, 32u);
  if (gl_SubgroupInvocationID < gl_SubgroupSize / piece_bits)
    pieces[lane / piece_bits + gl_SubgroupInvocationID] = votes[gl_SubgroupInvocationID];
#ifndef MUTANT_8  // the barrier dropped: joined before the higher subgroups have voted
  barrier();
#endif
  if (lane >= 2u || first_tile + lane >= tiles) return;
  uvec2 mask = uvec2(0u);
  for (uint bit = 0u; bit < 64u; bit += piece_bits) {
#ifdef MUTANT_9  // both tiles get the first one's votes
    mask[bit / 32u] |= pieces[bit / piece_bits] << bit % 32u;
#else
    mask[bit / 32u] |= pieces[(lane * 64u + bit) / piece_bits] << bit % 32u;
#endif
  }
  edge_mask[first_tile + lane] = mask;
}
