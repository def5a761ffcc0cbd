// A group a tile: its pixels in the order of the lists (tile_list.glsl), the pixels and waves of each shader in it.
// Scans and offsets come later.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/groups.glsl"
#include "kernels/pixel_commands/match.glsl"

void main() {
  const uint tile = spread_group();
  if (tile >= tile_count(extent())) return;  // the whole group
  clear_groups();
  clear_table();
  count_pixels(tile);
  group_surfaces();
  write_sums(tile);
  write_groups(tile);
  list_pixels(tile);
}
