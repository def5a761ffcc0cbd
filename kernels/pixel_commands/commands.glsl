// A tile's waves as commands: as many as they have binary digits set, the large ones first. A thread a row, so that the
// atomics of a tile do not wait for each other.
UPDATES(5, CommandRow, command_rows);
WRITES(7, uint, commands);

// `waves` waves from `wave` on: the commands of bucket k.
void append_commands(uint row, uint k, uint wave, uint waves) {
  const bool largest = k + 1u == kCommandBuckets;
  const uint count = largest ? waves >> k : waves >> k & 1u;
  if (count == 0u) return;
#ifdef MUTANT_23  // each command starts where the first did
  const uint first = wave;
#else
  const uint first = largest ? wave : wave + (waves >> k + 1u << k + 1u);
#endif
#ifdef MUTANT_22  // every command takes the row's first place
  const uint at = command_rows[row].first + atomicAdd(command_rows[row].count, count) * 0u;
#else
  const uint at = command_rows[row].first + atomicAdd(command_rows[row].count, count);
#endif
  for (uint i = 0u; i < count; ++i) commands[at + i] = first + (i << k);
}

void write_commands(uint tile) {
  for (uint i = gl_LocalInvocationID.x; i < shader_slots() * kOverflowRow; i += THREADS) {
    const uint shader = i / kOverflowRow, r = i % kOverflowRow;
    const uint wave = first_wave[shader];
    if (wave == kNowhere) continue;
    const uint kinds = tile_waves[shader], uniform_waves = kinds & 0xffffu;
    const bool uniform_list = r < kCommandBuckets;
    append_commands(shader * kCommandRows + r, r % kCommandBuckets, uniform_list ? wave : wave + uniform_waves,
                    uniform_list ? uniform_waves : kinds >> 16u);
  }
}
