// After match_runs.glsl and group_surfaces(): the pixels of a run side by side.
void list_run(uint tile, uint place, uint start, uint end) {
  for (uint i = start; i < end; ++i) {
#ifdef MUTANT_34  // the pixels of a run share one place
    const uint at = place;
#else
    const uint at = place + i - start;
#endif
    list_pixel(tile, at, first_pixel() + i, copies_of_pixel(pixel_of_thread(i)));
  }
}

void list_pixels(uint tile) {
  uint r = 0u;
  for (uint rest = run_starts; rest != 0u; ++r) {
    const uint start = findLSB(rest);
    rest &= rest - 1u;
    const uint place = run_place[r] == kFree ? kNowhere : pixels_at[run_place[r] >> kSlotBits];
    if (place == kNowhere) continue;
    list_run(tile, place + position_of(run_place[r]), start, rest != 0u ? findLSB(rest) : kPixelsPerThread);
  }
}
