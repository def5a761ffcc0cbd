// After match_lanes.glsl: a pixel at its place among those of its surface.
void write_pixels(uint tile) {
#ifndef MUTANT_33  // the barrier dropped: pixels go where slots of higher subgroups have yet to point
  barrier();
#endif
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    if (placed[i] == kFree) continue;
    const uint first = place_at[placed[i] >> kSlotBits];
    if (first == kNowhere) continue;
    const uint entry = first + (placed[i] & kTilePixels - 1u);
    entries[entry] = entry_of(pixel_of_tile(tile, pixel_of_thread(i), params.width));
  }
}
