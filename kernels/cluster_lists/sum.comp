#version 460
// Entries of each block of cells.
// Loop turns of an invocation: none but the steps of the sum.
#include "kernels/cluster_lists/common.glsl"

layout(local_size_x = kBlock) in;
READS(0, uvec2, cells);
WRITES(1, uint, block_entries);

shared uint sums[kBlock];

void main() {
  const uint thread = gl_LocalInvocationID.x, cell = gl_GlobalInvocationID.x;
  sums[thread] = cell < cell_count() ? most_of(unpack_cluster(cells[cell].y)) : 0u;
  barrier();
#ifdef MUTANT_5  // the block's first cell is left out
  for (uint reach = kBlock / 2u; reach > 0u; reach /= 2u) {
    if (thread < reach && thread > 0u) sums[thread] += sums[thread + reach];
#else
  for (uint reach = kBlock / 2u; reach > 0u; reach /= 2u) {
    if (thread < reach) sums[thread] += sums[thread + reach];
#endif
    barrier();
  }
  if (thread == 0u) block_entries[gl_WorkGroupID.x] = sums[0];
}
