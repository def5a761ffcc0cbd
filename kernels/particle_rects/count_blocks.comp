#version 460
// Of each block of particles: blocks of texels to be lit.
#include "kernels/particle_rects/common.glsl"
#include "kernels/particle_rects/blocks.glsl"

void main() {
  uint total;
  sum_through(block_count(gl_GlobalInvocationID.x), total);
  if (gl_LocalInvocationID.x == 0u) block_sums[gl_WorkGroupID.x] = uvec2(total, 0u);
}
