// A thread a particle: the i-th that wants a slot takes the i-th that is free. Who finds none claims what he had of the
// next size at once, beside those that have waited for it.
#include "kernels/particle_rects/common.glsl"
#include "kernels/particle_rects/blocks.glsl"

void place_all(uint size) {
  const Region r = region_of(size);
  const uint i = gl_GlobalInvocationID.x, own = uint(wants_slot(r, i));
  const uint before = sums_of_blocks(0u, gl_WorkGroupID.x).x;
  const uint found = sums_of_blocks(0u, gl_NumWorkGroups.x).y;
  uint total;
  const uint rank = before + sum_through(own, total) - own;
  count_nothing();
  if (waits_for(i, size)) place(r, i, rank, found);
  add_counts();
#ifndef MUTANT_14  // the smaller rectangles are all given anew
  if (size > 1u) claim(region_of(size - 1u), i);
#endif
}
