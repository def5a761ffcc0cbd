// How many commands a row has: the binary digits of the tiles' waves, what is above the last bucket counted in it.
#ifndef ADD_DIGIT  // the includer may count elsewhere
shared uint digits[kOverflowRow];
#define ADD_DIGIT(shader, row, n) atomicAdd(digits[row], n)

void clear_digits(uint thread) {
  if (thread < kOverflowRow) digits[thread] = 0u;
}
#endif

void add_digits(uint shader, uint word) {
  for (uint kind = 0u; kind < 2u; ++kind) {
    uint rest = kind == kUniformLists ? word & 0xffffu : word >> 16u;
    const uint most = rest >> kCommandBuckets - 1u;
#ifdef MUTANT_25  // one command of the last bucket, however many waves
    const uint times = min(most, 1u);
#else
    const uint times = most;
#endif
    if (most > 0u) ADD_DIGIT(shader, kind * kCommandBuckets + kCommandBuckets - 1u, times);
    for (rest &= (1u << kCommandBuckets - 1u) - 1u; rest > 0u; rest &= rest - 1u)
      ADD_DIGIT(shader, kind * kCommandBuckets + findLSB(rest), 1u);
  }
}
