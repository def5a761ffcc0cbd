#version 460
// One group goes through all of it, a thread a run of particles and of slots: no dispatch waits for another.
// Loop turns of an invocation: a run is 512 particles and 1024 slots at most; of these 8 and 5 passes in all, and 8192
// blocks: below 18,000.
#include "kernels/particle_rects/common.glsl"

struct Run {
  uint begin;
  uint end;
};
Run run_of(uint all) {
  const uint length = ceil_div(all, THREADS), begin = min(gl_LocalInvocationID.x * length, all);
  return Run(begin, min(begin + length, all));
}

void wait_for_all() {
  memoryBarrierBuffer();
  barrier();
}

void place_size(uint size, Run mine) {
  const Region r = region_of(size);
  const Run slots = run_of(r.slots);
  for (uint i = mine.begin; i < mine.end; ++i) claim(r, i);
  wait_for_all();
  uint want = 0u, here = 0u, all, found;
  for (uint i = mine.begin; i < mine.end; ++i) want += uint(wants_slot(r, i));
  for (uint s = slots.begin; s < slots.end; ++s) here += uint(is_free(r, s));
#ifdef MUTANT_15  // every run begins at the first
  uint rank = 0u;
  sum_through(want, all);
#else
  uint rank = sum_through(want, all) - want;
#endif
  uint at = sum_through(here, found) - here;
  for (uint s = slots.begin; s < slots.end; ++s)
    if (is_free(r, s)) free_slots[r.first + at++] = s;
  wait_for_all();
  for (uint i = mine.begin; i < mine.end; ++i) {
    const uint own = uint(wants_slot(r, i));
    if (waits_for(i, size)) place(r, i, rank, found);
    rank += own;
  }
  wait_for_all();
}

void main() {
  const Run mine = run_of(particle_count()), slots = run_of(all_slots());
  for (uint i = mine.begin; i < mine.end; ++i) start_particle(i);
  for (uint s = slots.begin; s < slots.end; ++s) owners[s] = kNobody;
  if (gl_LocalInvocationID.x == 0u) counts[0] = ParticleRectCounts(0u, 0u, 0u, 0u);
  count_nothing();
  wait_for_all();
  for (uint size = kRectSizes; size > 0u; --size) place_size(size, mine);
  add_counts();
  uint own = 0u, all;
  for (uint i = mine.begin; i < mine.end; ++i) own += block_count(i);
  uint at = sum_through(own, all) - own;
  for (uint i = mine.begin; i < mine.end; ++i) {
    list_blocks(i, at);
    at += block_count(i);
  }
  if (gl_LocalInvocationID.x == 0u) finish(all);
}
