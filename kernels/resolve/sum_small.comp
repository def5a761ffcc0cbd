#version 460
// What is commonly done: a pixel a thread, a tree in a group of 16x16.
#include "kernels/resolve/metering.glsl"
#include "kernels/resolve/tree.glsl"

layout(local_size_x = 256) in;
WRITES(1, PartialSum, small_partials);

void main() {
  const uint thread = gl_LocalInvocationIndex;
  const uvec2 pixel = gl_WorkGroupID.xy * kSmallBlock + uvec2(thread % 16u, thread / 16u);
  const PartialSum sum = tree_sum(metered(pixel), thread);
  if (thread == 0u) small_partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sum;
}
