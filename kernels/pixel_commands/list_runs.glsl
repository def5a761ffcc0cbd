// After match_runs.glsl and group_surfaces(): the pixels of a run side by side.
void list_run(uint tile, uint place, uint counted) {
  for (; counted != 0u; counted &= counted - 1u) {
    const uint i = findLSB(counted);
    list_pixel(tile, place, first_pixel() + i, copies_of_pixel(pixel_of_thread(i)));
#ifndef MUTANT_34  // the pixels of a run share one place
    ++place;
#endif
  }
}

void list_pixels(uint tile) {
  uint r = 0u;
  for (uint rest = run_starts; rest != 0u; ++r) {
    const uint counted = pixels_of_run(rest);
    rest &= rest - 1u;
    const uint place = run_place[r] == kFree ? kNowhere : pixels_at[run_place[r] >> kSlotBits];
    if (place == kNowhere) continue;
    list_run(tile, place + position_of(run_place[r]), counted);
  }
}
