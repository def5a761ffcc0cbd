// After match_runs.glsl: the pixels of a run side by side.
// From a run's place in its surface to its first entry, kNowhere where it has none.
void find_entries() {
  for (uint r = 0u; r < bitCount(run_starts); ++r) {
    const uint place = run_place[r];
    const uint first = place == kFree ? kNowhere : place_at[place >> kSlotBits];
    run_place[r] = first == kNowhere ? kNowhere : first + (place & kTilePixels - 1u);
  }
}

void write_pixels(uint tile) {
#ifndef MUTANT_20  // the barrier dropped: pixels go where slots of higher subgroups have yet to point
  barrier();
#endif
  find_entries();
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    const uint begun = run_starts & (2u << i) - 1u;  // of the runs up to pixel i
    const uint place = run_place[bitCount(begun) - 1u];
    if (place != kNowhere) entries[place + i - findMSB(begun)] = entry_of(pixel_of_thread(i));
  }
}
