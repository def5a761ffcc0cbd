// Neighbouring lanes take neighbouring pixels, and those of one surface are counted by one atomic of the subgroup: one
// turn a distinct surface.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require

// Where a pixel goes: its slot and how many of its surface are before it; kFree where it goes nowhere.
uint placed[kPixelsPerThread];

uint pixel_of_thread(uint i) { return i * THREADS + gl_LocalInvocationID.x; }

uint place_of(uint surface) {
  uint place = kFree;
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
    if (same) place = first;
#else
    if (same) place = first + subgroupBallotExclusiveBitCount(matching);
#endif
    rest &= ~matching;
  }
  return place;
}

void count_pixels(uint tile) {
  for (uint i = 0u; i < kPixelsPerThread; ++i)  // all at once: none waits for the table
    placed[i] = surface_of_pixel(pixel_of_tile(tile, pixel_of_thread(i), params.width));
  for (uint i = 0u; i < kPixelsPerThread; ++i) placed[i] = place_of(placed[i]);
}

// After group_surfaces().
void list_pixels(uint tile) {
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    if (placed[i] == kFree) continue;
    const uint place = pixels_at[placed[i] >> kSlotBits];
    if (place == kNowhere) continue;
    const uint pixel = pixel_of_thread(i);
    const uint copies = copies_of_pixel(pixel_of_tile(tile, pixel, params.width));
    list_pixel(tile, place + (placed[i] & kTilePixels - 1u), pixel, copies);
  }
}
