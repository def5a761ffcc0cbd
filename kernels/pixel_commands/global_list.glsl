// An atomic a pixel: the next position of its surface in the tile's list. Only what the last position of all leaves
// behind may carry into what lies above it, and nobody reads that.
#include "kernels/pixel_commands/global_pixels.glsl"
#include "kernels/pixel_commands/list_pixel.glsl"

void main() {
  const uvec2 pixel = this_pixel();
  const uint surface = surface_of_pixel(pixel);
  if (surface == kNoSurface) return;
  const uint slot = global_slot_of(pixel, surface);
  if (table_pixels[slot] == kNowhere) return;
  const uint place = atomicAdd(table_pixels[slot], 1u);
  list_pixel(tile_of_pixel(pixel, params.width), place, pixel.y % kTileSide * kTileSide + pixel.x % kTileSide,
             copies_of_pixel(pixel));
}
