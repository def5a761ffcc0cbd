// Of each block: particles that want a slot, and slots that are free.
#include "kernels/particle_rects/common.glsl"
#include "kernels/particle_rects/blocks.glsl"

void count(uint size) {
  const Region r = region_of(size);
  const uint i = gl_GlobalInvocationID.x;
  uvec2 total;
#ifdef MUTANT_12  // who keeps his own takes another too
  sum_through(uint(waits_for(i, size)), total.x);
#else
  sum_through(uint(wants_slot(r, i)), total.x);
#endif
  sum_through(uint(is_free(r, i)), total.y);
  if (gl_LocalInvocationID.x == 0u) block_sums[gl_WorkGroupID.x] = total;
}
