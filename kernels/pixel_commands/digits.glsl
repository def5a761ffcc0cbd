// How many commands a row has: the binary digits of the tiles' waves, what is above the last bucket counted in it.
#ifndef ADD_DIGIT  // the includer may count elsewhere
const uint kDigitColumns = 32u;  // neighbouring threads have a column each, for one word takes an atomic a turn
shared uint digits[kOverflowRow * kDigitColumns];
#define ADD_DIGIT(shader, row, n) \
  atomicAdd(digits[(row) * kDigitColumns + (gl_LocalInvocationID.x & kDigitColumns - 1u)], n)

void clear_digits(uint thread) {
  for (uint i = thread; i < kOverflowRow * kDigitColumns; i += kThreads) digits[i] = 0u;
}
uint sum_of_digits(uint row) {
  uint sum = 0u;
#ifdef MUTANT_42  // the first column alone
  for (uint column = 0u; column < 1u; ++column) sum += digits[row * kDigitColumns + column];
#else
  for (uint column = 0u; column < kDigitColumns; ++column) sum += digits[row * kDigitColumns + column];
#endif
  return sum;
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
