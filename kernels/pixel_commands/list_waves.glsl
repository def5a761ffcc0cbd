// A tile's list cut into waves: one begins where a group does, and whenever the last is full.
// Loop turns of an invocation: for its words of the list 32 to look back, 32 starts and the words before.
const uint kWaveNumberShift = 11u;       // kTilePixels itself is a position, behind the last wave
shared uint wave_at[kTilePixels + 1u];   // position of a wave's first pixel in bits 0..10, above it its number in the group
shared uint waves_in[kStartWords];       // that begin in a word of positions
shared uint waves;                       // of the tile

uint wave_position(uint wave) { return wave_at[wave] & (1u << kWaveNumberShift) - 1u; }
uint wave_number(uint wave) { return wave_at[wave] >> kWaveNumberShift; }

// Bits of the positions that begin a wave. `start`: where the group that the word's first position is in began.
uint wave_starts(uint word, uint start) {
  const uint begin = word * 32u, end = min(begin + 32u, listed);
  uint rest = group_starts[word], starts = 0u;
#ifdef MUTANT_20  // a group that goes on from the word before begins a wave
  uint at = begin;
#else
  uint at = start + (waves_of(begin - start) << wave_log2());
#endif
  for (;;) {
    const uint limit = rest == 0u ? end : begin + findLSB(rest);
    for (; at < limit; at += wave_size()) starts |= 1u << at - begin;
    if (rest == 0u) return starts;
    at = limit;
    rest &= rest - 1u;
  }
}
uint wave_starts(uint word) {
  if (word * 32u >= listed) return 0u;
  return wave_starts(word, group_start(word * 32u));
}

void list_waves() {
  for (uint w = gl_LocalInvocationID.x; w < kStartWords; w += THREADS) waves_in[w] = bitCount(wave_starts(w));
  barrier();
  for (uint w = gl_LocalInvocationID.x; w < kStartWords; w += THREADS) {
    uint wave = 0u;
    for (uint below = 0u; below < w; ++below) wave += waves_in[below];
    for (uint rest = wave_starts(w); rest != 0u; rest &= rest - 1u) {
      const uint position = w * 32u + findLSB(rest);
      wave_at[wave++] = position | position - group_start(position) >> wave_log2() << kWaveNumberShift;
    }
    if (w + 1u < kStartWords) continue;
    waves = wave;
    wave_at[wave] = listed;
  }
}
