// A thread takes neighbouring pixels of a row, and a run of one surface among them is counted by one atomic. Where runs
// begin is found first, for most threads have one or two: what is done to a run is not paid for by every pixel. Duplicates
// lie within a run and do not end it, else most pixels of a coarse rate would be runs of their own.

uvec2 thread_pixels;                // the thread's first pixel; the others are to its right
uint run_starts;                    // bit i: pixel i begins a run
#ifdef COPY_BITS
uint run_pixels;                    // bit i: pixel i is counted
#else
const uint run_pixels = ~0u >> 32u - kPixelsPerThread;
#endif
uint run_place[kPixelsPerThread];   // a run's slot, and how many pixels of its surface are before it; kFree: nowhere

uvec2 pixel_of_thread(uint i) { return uvec2(thread_pixels.x + i, thread_pixels.y); }
uint first_pixel() { return gl_LocalInvocationID.x * kPixelsPerThread; }  // of the tile's

void find_runs(uint tile) {
  thread_pixels = pixel_of_tile(tile, first_pixel(), params.width);
  run_starts = 1u;
  uint current = surface_of_pixel(thread_pixels);
#ifdef COPY_BITS
  run_pixels = uint(!is_duplicate(thread_pixels));
#endif
  for (uint i = 1u; i < kPixelsPerThread; ++i) {
#ifdef COPY_BITS
    if (is_duplicate(pixel_of_thread(i))) continue;
    run_pixels |= 1u << i;
#endif
    const uint surface = surface_of_pixel(pixel_of_thread(i));
    run_starts |= uint(surface != current) << i;
    current = surface;
  }
}

uint bits_under(uint bits) { return (bits & ~bits + 1u) - 1u; }  // the lowest one that is set; all where none is

// The run that begins with the first bit of `rest`: its pixels that are counted.
uint pixels_of_run(uint rest) {
  const uint later = rest & rest - 1u;
  return run_pixels & bits_under(later) & ~bits_under(rest);
}

void count_pixels(uint tile) {
  find_runs(tile);
  uint r = 0u;
  for (uint rest = run_starts; rest != 0u; ++r) {
    const uint start = findLSB(rest), length = bitCount(pixels_of_run(rest));
    rest &= rest - 1u;
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
