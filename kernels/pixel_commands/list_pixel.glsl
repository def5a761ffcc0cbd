#include "kernels/pixel_commands/tile_list.glsl"
WRITES(10, uint, tile_lists);

// A pixel of the tile at its place; `place` is its surface's, moved on by the pixels of it that are before.
void list_pixel(uint tile, uint place, uint pixel, uint copies) {
  tile_lists[tile * kTilePixels + position_of(place)] =
      place >> kPlaceBits << kListKeyShift | copies << kListCopyShift | pixel;
}
