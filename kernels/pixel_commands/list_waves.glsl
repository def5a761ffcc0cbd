// A tile's list cut into waves: one begins where a group does, and whenever the last is full. A thread looks at a word
// of positions.
// Loop turns of an invocation: 3 and 32 for the waves of a word, and the 8 words of counts.
const uint kWaveNumberShift = 11u;      // kTilePixels itself is a position, behind the last wave
shared uint wave_at[kTilePixels + 1u];   // position of a wave's first pixel in bits 0..10, above it its number
shared uint waves_in[kStartWords / 4u];  // that begin in a word of positions, 8 bits for each
shared uint waves;                       // of the tile
uint wave_position(uint wave) { return wave_at[wave] & bits_below(kWaveNumberShift); }
uint wave_number(uint wave) { return wave_at[wave] >> kWaveNumberShift; }

void clear_waves() {
  for (uint i = gl_LocalInvocationID.x; i < kStartWords / 4u; i += THREADS) waves_in[i] = 0u;
}

// Bits of the positions that begin a wave. `start`: where the group that goes on from the word before began.
uint wave_starts(uint word, uint start) {
  const uint begin = word * 32u, log2 = wave_log2(), begun = group_starts[word];
  uint last = begun;  // of the waves found, those that the next may follow
#ifdef MUTANT_20  // a group that goes on from the word before begins a wave
  const uint at = 0u;
#else
  const uint at = (waves_of(begin - start) << log2) - (begin - start);
#endif
  if (at < 32u && (begun & (2u << at) - 1u) == 0u) last |= 1u << at;
  uint starts = last;
  if (log2 < 5u) {  // several waves of a group in a word; none follows where another group begins on the way
    uint cut = begun;
    for (uint reach = 1u; reach < 1u << log2; reach *= 2u) cut |= cut << reach;
    for (uint i = 1u; i < 32u >> log2; ++i) {
      last = last << (1u << log2) & ~cut;
      starts |= last;
    }
  }
  return begin + 32u <= listed ? starts : begin < listed ? starts & bits_below(listed - begin) : 0u;
}

uint waves_before(uint word) {
  uint sum = 0u;
  for (uint i = 0u; i * 4u < word; ++i) {
    const uint counts = waves_in[i] & (word >= i * 4u + 4u ? ~0u : bits_below((word & 3u) * 8u));
    sum += counts * 0x01010101u >> 24u;  // at most 4 * 32
  }
  return sum;
}

// After a barrier since clear_waves().
void list_waves() {
  const uint word = gl_LocalInvocationID.x;
  uint starts = 0u, start = 0u;
  if (word < kStartWords) {
    if (word > 0u && word * 32u < listed) start = start_before(word);
    starts = wave_starts(word, start);
    atomicAdd(waves_in[word / 4u], bitCount(starts) << word % 4u * 8u);
  }
  barrier();
  if (word >= kStartWords) return;
  uint wave = waves_before(word);
  for (uint rest = starts; rest != 0u; rest &= rest - 1u) {
    const uint bit = findLSB(rest), begun = group_starts[word] & (2u << bit) - 1u;
    const uint group = begun != 0u ? word * 32u + findMSB(begun) : start;
    wave_at[wave++] = word * 32u + bit | word * 32u + bit - group >> wave_log2() << kWaveNumberShift;
  }
  if (word + 1u < kStartWords) return;
  waves = wave;
  wave_at[wave] = listed;
}
