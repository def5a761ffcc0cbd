// A thread takes neighbouring pixels of a row, and a run of one surface among them is counted by one atomic. The runs are
// found first, for most threads have one or two: what is done to a run is not paid for by every pixel.
uint pixel_of_thread(uint i) { return gl_LocalInvocationID.x * kPixelsPerThread + i; }

uint run_surface[kPixelsPerThread];
uint run_end[kPixelsPerThread];
uint run_place[kPixelsPerThread];  // its slot, and how many pixels of its surface are before it; kFree: it goes nowhere
uint runs;

void find_runs(uint tile) {
  uint current = kNoSurface;
  runs = 0u;
  for (uint i = 0u; i < kPixelsPerThread; ++i) {
    const uint surface = surface_of_pixel(pixel_of_tile(tile, pixel_of_thread(i), params.width));
    if (i == 0u || surface != current) ++runs;
    run_surface[runs - 1u] = surface;
    run_end[runs - 1u] = i + 1u;
    current = surface;
  }
}

void count_pixels(uint tile) {
  find_runs(tile);
  for (uint r = 0u; r < runs; ++r) {
    run_place[r] = kFree;
    if (run_surface[r] == kNoSurface) continue;
    const uint slot = slot_of(run_surface[r]);
    const uint length = run_end[r] - (r > 0u ? run_end[r - 1u] : 0u);
#ifdef MUTANT_8  // a lost atomic
    const uint before = pixels_at[slot];
    pixels_at[slot] = before + length;
#else
    const uint before = atomicAdd(pixels_at[slot], length);
#endif
    run_place[r] = slot << kSlotBits | before;
  }
}
