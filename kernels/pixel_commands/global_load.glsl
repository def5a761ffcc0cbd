// The table of a tile from global memory, as count_pixels() would have filled it.
READS(0, uint, table_surfaces);

void load_table(uint tile) {
  for (uint i = gl_LocalInvocationID.x; i < kTilePixels; i += THREADS) {
    surface_at[i] = table_surfaces[tile * kTilePixels + i];
    pixels_at[i] = table_pixels[tile * kTilePixels + i];
    if (surface_at[i] != kFree) used_slots[atomicAdd(used, 1u)] = i;
  }
}
