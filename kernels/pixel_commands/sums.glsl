// Sums of entries, which may be over 2^32.
uint saturating_sum(uint a, uint b) {
  const uint sum = a + b;
#ifdef MUTANT_1  // wraps: a list over 2^32 looks empty
  return sum;
#else
  return sum < a ? 0xffffffffu : sum;
#endif
}
// Entries that fill up `waves` waves of `pixels` pixels.
uint padding_of(uint waves, uint pixels) {
  uint high, low, borrow;
  umulExtended(waves, wave_size(), high, low);
  low = usubBorrow(low, pixels, borrow);
  return high != borrow ? 0xffffffffu : low;
}
