// Depths as whole numbers: 24 bits of mantissa and an exponent, so that nothing is rounded. Depths given as bits, 0
// where there is none.
uint mantissa(uint depth) { return depth & 0x7fffffu | 0x800000u; }

bool close_depths(uint a, uint b) {
  if (a == 0u || b == 0u) return false;
  const uint greater = max(a, b), smaller = min(a, b), shift = (greater >> 23u) - (smaller >> 23u);
  const uint most = mantissa(greater), least = shift < 24u ? mantissa(smaller) >> shift : 0u;
#ifdef MUTANT_14  // just apart
  return most - least < most >> min(params.close_depths_log2, 23u);
#else
  return most - least <= most >> min(params.close_depths_log2, 23u);
#endif
}
