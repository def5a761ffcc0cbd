// A group a block: its pairs to their places. A thread counts its own pairs in a column of its own, so that equal digits
// keep their order without an atomic.
#include "kernels/pixel_commands/sort.glsl"

layout(local_size_x = kThreads) in;
READS(0, uint, FROM_KEYS);
READS(1, uint, FROM);
WRITES(2, uint, TO_KEYS);
WRITES(3, uint, TO);
READS(4, uint, digit_counts);
READS(5, uint, sort_shift);

shared uint counts[kDigits * kThreads];  // digit after digit, a thread
shared uint sums[kThreads];
shared uint digit_first[kDigits];  // place of the block's first pair of the digit, less its number in the block

// `counts` becomes how many of the block's pairs are before the thread's first of each digit.
void scan_counts(uint thread) {
  uint own = 0u;
  for (uint i = 0u; i < kDigits; ++i) own += counts[thread * kDigits + i];
  sums[thread] = own;
  barrier();
  uint before = 0u;
  for (uint t = 0u; t < thread; ++t) before += sums[t];
  for (uint i = 0u; i < kDigits; ++i) {
    const uint count = counts[thread * kDigits + i];
    counts[thread * kDigits + i] = before;
    before += count;
  }
#ifndef MUTANT_30  // the barrier dropped: digits begin where higher subgroups have yet to say
  barrier();
#endif
}

void main() {
  const uint block = spread_group(), thread = gl_LocalInvocationID.x;
  if (block >= blocks()) return;  // the whole group
  const uint shift = sort_shift[1];
  for (uint d = 0u; d < kDigits; ++d) counts[d * kThreads + thread] = 0u;
  for (uint i = 0u; i < kPairsPerThread; ++i)
    if (pair_of(block, i) < pairs()) ++counts[digit_of(FROM_KEYS[pair_of(block, i)], shift) * kThreads + thread];
  barrier();
  scan_counts(thread);
  if (thread < kDigits) {
    uint first = digit_counts[thread * blocks() + block] - counts[thread * kThreads];
    for (uint d = 0u; d < thread; ++d) first += digit_counts[kDigits * blocks() + d];
    digit_first[thread] = first;
  }
  barrier();
  for (uint i = 0u; i < kPairsPerThread; ++i) {
    const uint pair = pair_of(block, i);
    if (pair >= pairs()) break;
    const uint digit = digit_of(FROM_KEYS[pair], shift);
    const uint to = digit_first[digit] + counts[digit * kThreads + thread]++;
    TO_KEYS[to] = FROM_KEYS[pair];
    TO[to] = FROM[pair];
  }
}
