// A dispatch a shader, tile and kind, in place of lists of commands: x groups, none for a tile in the overflow.
WRITES(7, DispatchArgs, tile_args);

void dispatch_tile(uint shader, uint tile) {
  const uint at = shader * tile_count(extent()) + tile;
  const bool padded = tile < shaders[shader].padded_tiles;
  for (uint kind = 0u; kind < 2u; ++kind) {
#ifdef MUTANT_32  // the overflow's waves are dispatched by tile too
    const uint waves = shader_waves[shader] >> 16u * kind & 0xffffu;
#else
    const uint waves = padded ? shader_waves[shader] >> 16u * kind & 0xffffu : 0u;
#endif
    tile_args[at * 2u + kind] = DispatchArgs(ceil_div(waves, 1u << waves_per_group_log2()), 1u, 1u);
  }
}
