WRITES(3, TileCommands, tiles);

void count_tile(uint tile) {
  const uint all = tile_count(extent());
  if (tile >= all) return;  // the whole group
  clear_groups();
  clear_table();
  count_pixels(tile);
  group_surfaces();
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS)
    tiles[s * all + tile] = TileCommands(shader_pixels[s], shader_waves[s], 0u, 0u);
}
