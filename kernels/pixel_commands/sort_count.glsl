// A group a block: how many of its pairs have each digit.
#include "kernels/pixel_commands/sort.glsl"

layout(local_size_x = kThreads) in;
READS(0, uint, FROM_KEYS);
READS(1, uint, sort_shift);
WRITES(2, uint, digit_counts);

shared uint counts[kDigits];

void main() {
  const uint block = spread_group();
  if (block >= blocks()) return;  // the whole group
  if (gl_LocalInvocationID.x < kDigits) counts[gl_LocalInvocationID.x] = 0u;
  barrier();
  for (uint i = 0u; i < kPairsPerThread; ++i) {
    const uint pair = pair_of(block, i);
    if (pair < pairs()) atomicAdd(counts[digit_of(FROM_KEYS[pair], sort_shift[0])], 1u);
  }
  barrier();
  if (gl_LocalInvocationID.x < kDigits)
    digit_counts[gl_LocalInvocationID.x * blocks() + block] = counts[gl_LocalInvocationID.x];
}
