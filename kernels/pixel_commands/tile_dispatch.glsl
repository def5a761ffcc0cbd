// A dispatch a shader, tile and kind, in place of lists of commands: x groups, none for a tile in the overflow.
WRITES(7, DispatchArgs, tile_args);

void write_commands(uint tile) {
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS) {
    const uint at = s * tile_count(extent()) + tile;
    for (uint kind = 0u; kind < 2u; ++kind) {
#ifdef MUTANT_32  // the overflow's waves are dispatched by tile too
      const uint waves = tile_waves[s] >> 16u * kind & 0xffffu;
#else
      const uint waves = first_wave[s] == kNowhere ? 0u : tile_waves[s] >> 16u * kind & 0xffffu;
#endif
      tile_args[at * 2u + kind] = DispatchArgs(ceil_div(waves, 1u << waves_per_group_log2()), 1u, 1u);
    }
  }
}
