// An atomic a pixel. The table is cleared before.
#include "kernels/pixel_commands/global_pixels.glsl"

void main() {
  const uvec2 pixel = this_pixel();
  const uint surface = surface_of_pixel(pixel);
  if (surface == kNoSurface) return;
  const uint slot = global_slot_of(pixel, surface);
#ifdef MUTANT_29  // a lost atomic
  table_pixels[slot] = table_pixels[slot] + 1u;
#else
  atomicAdd(table_pixels[slot], 1u);
#endif
}
