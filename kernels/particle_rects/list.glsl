// A thread a slot: those that are free, in a row, ascending.
#include "kernels/particle_rects/common.glsl"
#include "kernels/particle_rects/blocks.glsl"

void list(uint size) {
  const Region r = region_of(size);
  const uint slot = gl_GlobalInvocationID.x, own = uint(is_free(r, slot));
  const uint before = sums_of_blocks(0u, gl_WorkGroupID.x).y;
  uint total;
#ifdef MUTANT_13  // inclusive
  const uint rank = before + sum_through(own, total);
#else
  const uint rank = before + sum_through(own, total) - own;
#endif
  if (own != 0u) free_slots[r.first + rank] = slot;
}
