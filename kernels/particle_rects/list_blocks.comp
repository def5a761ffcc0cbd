#version 460
// A thread a particle: its blocks, after those of the particles before.
#include "kernels/particle_rects/common.glsl"
#include "kernels/particle_rects/blocks.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x, own = block_count(i);
  const uint before = sums_of_blocks(0u, gl_WorkGroupID.x).x;
  uint total;
  const uint through = before + sum_through(own, total);
  list_blocks(i, through - own);
  if (i + 1u == particle_count()) finish(through);
}
