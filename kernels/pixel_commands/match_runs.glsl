// A thread takes neighbouring pixels of a row, and a run of one surface among them is counted by one atomic. Where runs
// begin is found first, for most threads have one or two: what is done to a run is not paid for by every pixel.

uvec2 thread_pixels;                // the thread's first pixel; the others are to its right
uint run_starts;                    // bit i: pixel i begins a run
uint run_place[kPixelsPerThread];   // a run's slot, and how many pixels of its surface are before it; kFree: nowhere

uvec2 pixel_of_thread(uint i) { return uvec2(thread_pixels.x + i, thread_pixels.y); }
uint first_pixel() { return gl_LocalInvocationID.x * kPixelsPerThread; }  // of the tile's

void find_runs(uint tile) {
  thread_pixels = pixel_of_tile(tile, first_pixel(), params.width);
  run_starts = 1u;
  uint current = surface_of_pixel(thread_pixels);
  for (uint i = 1u; i < kPixelsPerThread; ++i) {
    const uint surface = surface_of_pixel(pixel_of_thread(i));
    run_starts |= uint(surface != current) << i;
    current = surface;
  }
}

void count_pixels(uint tile) {
  find_runs(tile);
  uint r = 0u;
  for (uint rest = run_starts; rest != 0u; ++r) {
    const uint start = findLSB(rest);
    rest &= rest - 1u;
    const uint length = (rest != 0u ? findLSB(rest) : kPixelsPerThread) - start;
    const uint surface = surface_of_pixel(pixel_of_thread(start));  // again: an array of them would cost a store a pixel
    run_place[r] = kFree;
    if (surface == kNoSurface) continue;
    const uint slot = slot_of(surface);
#ifdef MUTANT_8  // a lost atomic
    const uint before = pixels_at[slot];
    pixels_at[slot] = before + length;
#else
    const uint before = atomicAdd(pixels_at[slot], length);
#endif
    run_place[r] = slot << kSlotBits | before;
  }
}

#ifdef STABLE
#include "kernels/pixel_commands/list_stable.glsl"
#else
#include "kernels/pixel_commands/list_runs.glsl"
#endif
