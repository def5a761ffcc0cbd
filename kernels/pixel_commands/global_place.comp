#version 460
// A group a tile: puts the place of each of its surfaces into the table, and writes all but the pixels.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
UPDATES(2, uint, table_pixels);
#include "kernels/pixel_commands/global_load.glsl"
#include "kernels/pixel_commands/place.glsl"

void main() {
  const uint tile = spread_group();
  if (tile >= tile_count(extent())) return;  // the whole group
  clear_groups();
  clear_table();
  load_table(tile);
  place_groups(tile);
#ifndef MUTANT_34  // the barrier dropped: waves of groups that higher subgroups have yet to place
  barrier();
#endif
  for (uint i = gl_LocalInvocationID.x; i < used; i += THREADS)
    table_pixels[tile * kTilePixels + used_slots[i]] = place_at[used_slots[i]];
  write_waves(tile);
  write_commands(tile);
}
