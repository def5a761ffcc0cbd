#version 460
// A group a digit: the pairs of it in the blocks before each, and in all of them, behind the blocks' counts. The count of
// the next pass then takes the next digit, the scatter of this one still takes this.
// Loop turns of an invocation: twice its share of the blocks, 512 of 2^28 pixels, and the threads.
#include "kernels/pixel_commands/sort.glsl"

layout(local_size_x = kThreads) in;
UPDATES(0, uint, digit_counts);
UPDATES(1, uint, sort_shift);

shared uint sums[kThreads];

void main() {
  const uint digit = gl_WorkGroupID.x, thread = gl_LocalInvocationID.x;
  const uint share = ceil_div(blocks(), kThreads);
  const uint begin = min(thread * share, blocks()), end = min(begin + share, blocks());
  uint own = 0u;
  for (uint b = begin; b < end; ++b) own += digit_counts[digit * blocks() + b];
  sums[thread] = own;
  barrier();
  uint before = 0u, total = 0u;
  for (uint t = 0u; t < kThreads; ++t) {
#ifdef MUTANT_31  // a block's own pairs are before it
    if (t <= thread) before += sums[t];
#else
    if (t < thread) before += sums[t];
#endif
    total += sums[t];
  }
  for (uint b = begin; b < end; ++b) {
    const uint count = digit_counts[digit * blocks() + b];
    digit_counts[digit * blocks() + b] = before;
    before += count;
  }
  if (thread == 0u) digit_counts[kDigits * blocks() + digit] = total;
  if (digit == 0u && thread == 0u) {
    sort_shift[1] = sort_shift[0];
    sort_shift[0] += 4u;
  }
}
