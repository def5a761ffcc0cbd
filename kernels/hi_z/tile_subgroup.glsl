// As tile_shared, but a subgroup joins its own texels by exchanging lanes: a level at widths from 4, two from 16, three
// from 64. What is left, a texel for each stride of lanes, is joined in shared memory.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "kernels/hi_z/tile.glsl"

uvec2 exchanged(uvec2 range, uint lanes) {
  return joined(range, uvec2(subgroupShuffleXor(range.x, lanes), subgroupShuffleXor(range.y, lanes)));
}

void reduce_tile(uint below, uvec2 tile) {
  // Numbered by subgroup: widths from 4 to 128 fill the group exactly.
  const uint thread = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
  uvec2 range = range_below(below + 1u, tile * 16u + morton(thread));
  store_in_tile(below, 1u, tile, thread, range);
  uint step = 2u, stride = 1u;
  for (; 4u * stride <= gl_SubgroupSize; stride *= 4u, ++step) {
#ifdef MUTANT_8  // the lower two of four are left out
    range = exchanged(range, stride);
#else
    range = exchanged(exchanged(range, stride), 2u * stride);
#endif
    if (thread % (4u * stride) == 0u) store_in_tile(below, step, tile, thread / (4u * stride), range);
  }
#ifdef MUTANT_9  // a lane's own texel goes where its subgroup's should
  of_tile[thread] = range;
#else
  if (thread % stride == 0u) of_tile[thread / stride] = range;
#endif
  reduce_in_shared(below, step, tile, thread);
}
