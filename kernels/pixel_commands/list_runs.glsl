// After match_runs.glsl and group_surfaces(): the pixels of a run side by side.
void place_runs() {
  for (uint r = 0u; r < bitCount(run_starts); ++r) {
    const uint place = run_place[r];
    const uint first = place == kFree ? kNowhere : pixels_at[place >> kSlotBits];
    run_place[r] = first == kNowhere ? kNowhere : first + (place & kTilePixels - 1u);
  }
}

void list_pixels(uint tile) {
  place_runs();
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    const uint begun = run_starts & (2u << i) - 1u;  // of the runs up to pixel i
    const uint place = run_place[bitCount(begun) - 1u];
    if (place == kNowhere) continue;
#ifdef MUTANT_34  // the pixels of a run share one place
    const uint at = place;
#else
    const uint at = place + i - findMSB(begun);
#endif
    list_pixel(tile, at, first_pixel() + i, copies_of_pixel(pixel_of_thread(i)));
  }
}
