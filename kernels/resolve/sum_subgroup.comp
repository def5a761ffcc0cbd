#version 460
// As sum_shared, but a subgroup adds its own part of the tree by exchanging lanes: the tree's lower levels, the same
// pairs, without shared memory or barriers. What is left, a value a subgroup, is added as before.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "kernels/resolve/metering.glsl"

layout(local_size_x = 256) in;
WRITES(1, PartialSum, partials);

shared PartialSum of_subgroup[64];  // at width 4: 256 / 4

void main() {
  // Numbered by subgroup, so that a subgroup holds neighbours of the tree, however lanes map to invocations. Widths from
  // 4 to 128 fill the group exactly.
  const uint thread = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
  PartialSum mine = metered_thread(gl_WorkGroupID.xy, thread);
#ifdef MUTANT_6  // the last exchange left out
  for (uint stride = 1u; 2u * stride < gl_SubgroupSize; stride *= 2u)
#else
  for (uint stride = 1u; stride < gl_SubgroupSize; stride *= 2u)
#endif
    mine = joined(mine, PartialSum(subgroupShuffleXor(mine.sum, stride), subgroupShuffleXor(mine.counted, stride)));
  if (gl_SubgroupInvocationID == 0u) of_subgroup[gl_SubgroupID] = mine;
#ifndef MUTANT_7  // the barrier dropped: read before the higher subgroups have written
  barrier();
#endif
  if (thread != 0u) return;
  for (uint stride = 1u; stride < gl_NumSubgroups; stride *= 2u)
    for (uint i = 0u; i + stride < gl_NumSubgroups; i += 2u * stride)
      of_subgroup[i] = joined(of_subgroup[i], of_subgroup[i + stride]);
  partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = of_subgroup[0];
}
