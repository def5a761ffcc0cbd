// Sums of blocks that lie in memory between two passes, and those before this group's.
UPDATES(8, uvec2, block_sums);  // of particles, of slots

// Loop turns: blocks over threads, 4 of 262,144 slots.
uvec2 sums_of_blocks(uint begin, uint end) {
  uvec2 own = uvec2(0u), total;
  for (uint b = begin + gl_LocalInvocationID.x; b < end; b += THREADS) own += block_sums[b];
  sum_through(own.x, total.x);
  sum_through(own.y, total.y);
  return total;
}
