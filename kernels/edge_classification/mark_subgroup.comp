#version 460
// A tile a subgroup, in 64 / width turns (at width 128 two tiles in one): no shared memory and no barrier. A group of
// 128 threads takes 32 tiles, whatever the width. Turns of an invocation: 16 at every width up to 64.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "kernels/edge_classification/common.glsl"

layout(local_size_x = 128) in;
WRITES(2, uvec2, edge_mask);

void main() {
  const uint tiles = edge_tile_count();
  const uint first_tile = spread_group() * 32u;
  const uint end = min(first_tile + 32u, tiles);
  const uint width = gl_SubgroupSize;
  const uint lane = gl_SubgroupInvocationID;
  const uint at_once = max(width / 64u, 1u);  // tiles
  for (uint tile = first_tile + gl_SubgroupID * at_once; tile < end; tile += gl_NumSubgroups * at_once) {
    uvec4 mask = uvec4(0u);
    for (uint bit = 0u; bit < 64u; bit += width) {
      const uint mine = tile + (bit + lane) / 64u;
      const uint pixel = (bit + lane) % 64u;
#ifdef MUTANT_10  // the lower half of the tile is left out
      const uvec4 votes = subgroupBallot(mine < end && pixel < 32u && is_edge(mine, pixel));
#else
      const uvec4 votes = subgroupBallot(mine < end && is_edge(mine, pixel));
#endif
      if (width <= 32u) mask[bit / 32u] |= votes.x << bit % 32u;
      else mask = votes;
    }
#ifdef MUTANT_11  // the lower half's votes land on the upper half's bits
    mask = uvec4(mask.x | mask.y, 0u, mask.z | mask.w, 0u);
#endif
    if (lane < at_once && tile + lane < end) edge_mask[tile + lane] = lane == 0u ? mask.xy : mask.zw;
  }
}
