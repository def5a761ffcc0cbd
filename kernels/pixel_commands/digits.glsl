// How many commands a row has: the binary digits of the tiles' waves, what is above the last bucket counted in it.
shared uint digits[kOverflowRow];

void clear_digits(uint thread) {
  if (thread < kOverflowRow) digits[thread] = 0u;
}

void add_digits(uint word) {
  for (uint kind = 0u; kind < 2u; ++kind) {
    uint rest = kind == kUniformLists ? word & 0xffffu : word >> 16u;
    const uint most = rest >> kCommandBuckets - 1u;
#ifdef MUTANT_25  // one command of the last bucket, however many waves
    const uint times = min(most, 1u);
#else
    const uint times = most;
#endif
    if (most > 0u) atomicAdd(digits[kind * kCommandBuckets + kCommandBuckets - 1u], times);
    for (rest &= (1u << kCommandBuckets - 1u) - 1u; rest > 0u; rest &= rest - 1u)
      atomicAdd(digits[kind * kCommandBuckets + findLSB(rest)], 1u);
  }
}
