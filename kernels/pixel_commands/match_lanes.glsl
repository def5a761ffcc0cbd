// Neighbouring lanes take neighbouring pixels, and those of one surface are counted by one atomic of the subgroup: one
// turn a distinct surface.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require

// Where a pixel goes: its slot and how many of its surface are before it; kFree where it goes nowhere.
uint placed[kPixelsPerThread];

uint pixel_of_thread(uint i) { return i * THREADS + gl_LocalInvocationID.x; }

void count_pixels(uint tile) {
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    const uint surface = surface_of_pixel(pixel_of_tile(tile, pixel_of_thread(i), params.width));
    placed[i] = kFree;
    uvec4 rest = subgroupBallot(surface != kNoSurface);
    while (rest != uvec4(0u)) {
      const uint leader = subgroupBallotFindLSB(rest);
      const bool same = subgroupBroadcast(surface, leader) == surface;
      const uvec4 matching = subgroupBallot(same);
      uint first = 0u;
      if (gl_SubgroupInvocationID == leader) {
        const uint slot = slot_of(surface);
        first = slot << kSlotBits | atomicAdd(pixels_at[slot], subgroupBallotBitCount(matching));
      }
      first = subgroupBroadcast(first, leader);
#ifdef MUTANT_7  // the lanes of a surface share one place
      if (same) placed[i] = first;
#else
      if (same) placed[i] = first + subgroupBallotExclusiveBitCount(matching);
#endif
      rest &= ~matching;
    }
  }
}
