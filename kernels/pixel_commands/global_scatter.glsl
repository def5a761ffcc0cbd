// An atomic a pixel: the next entry of its surface.
#include "kernels/pixel_commands/global_pixels.glsl"
WRITES(6, uint, entries);

void main() {
  const uvec2 pixel = this_pixel();
  const uint surface = surface_of_pixel(pixel);
  if (surface == kNoSurface) return;
  const uint slot = global_slot_of(pixel, surface);
  if (table_pixels[slot] != kNowhere) entries[atomicAdd(table_pixels[slot], 1u)] = entry_of(pixel);
}
