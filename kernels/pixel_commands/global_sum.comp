#version 460
// A group a tile: groups the surfaces of its table in global memory, as count.glsl does, and puts into the table where
// the pixels of each stand.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/groups.glsl"
READS(0, uint, table_surfaces);
UPDATES(2, uint, table_pixels);

// The table as count_pixels() would have filled it.
void load_table(uint tile) {
  for (uint i = gl_LocalInvocationID.x; i < kTilePixels; i += THREADS) {
    surface_at[i] = table_surfaces[tile * kTilePixels + i];
    pixels_at[i] = table_pixels[tile * kTilePixels + i];
    if (surface_at[i] != kFree) used_slots[atomicAdd(used, 1u)] = i;
  }
}

void main() {
  const uint tile = spread_group();
  if (tile >= tile_count(extent())) return;  // the whole group
  clear_groups();
  clear_table();
  load_table(tile);
  group_surfaces();
  write_sums(tile);
  write_groups(tile);
  for (uint i = gl_LocalInvocationID.x; i < used; i += THREADS)
    table_pixels[tile * kTilePixels + slot_at(i)] = pixels_at[slot_at(i)];
}
