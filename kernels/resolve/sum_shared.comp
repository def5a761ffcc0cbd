#version 460
// A group sums 128x128 pixels: 8x8 a thread, then a tree through shared memory.
#include "kernels/resolve/metering.glsl"
#include "kernels/resolve/tree.glsl"

layout(local_size_x = 256) in;
WRITES(1, PartialSum, partials);

void main() {
  const uint thread = gl_LocalInvocationIndex;
  const PartialSum sum = tree_sum(metered_thread(gl_WorkGroupID.xy, thread), thread);
  if (thread == 0u) partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sum;
}
