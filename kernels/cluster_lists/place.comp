#version 460
// Where each cell's entries begin: after those of the cells before. What is past the list's end is dropped, highest
// indices first.
// Loop turns of an invocation: 4 blocks, the steps of a scan.
#include "kernels/cluster_lists/common.glsl"

const uint THREADS = kBlock, SCANNED = kBlock;
layout(local_size_x = THREADS) in;
READS(0, uint, block_entries);
UPDATES(3, uvec2, cells);
#include "kernels/cluster_lists/counted.glsl"
#include "harness/glsl/scan.glsl"

void main() {
  const uint thread = gl_LocalInvocationID.x, cell = gl_GlobalInvocationID.x, block = gl_WorkGroupID.x;
  uint earlier = 0u;
#ifdef MUTANT_7  // the block's own entries count as earlier ones
  for (uint i = thread; i <= block; i += THREADS) earlier += block_entries[i];
#else
  for (uint i = thread; i < block; i += THREADS) earlier += block_entries[i];
#endif
  uint before_block, of_block;
  sum_through(earlier, before_block);

  const bool is_cell = cell < cell_count();
  const uvec3 wanted = is_cell ? unpack_cluster(cells[cell].y) : uvec3(0u);
  const uint through = sum_through(most_of(wanted), of_block);
  if (!is_cell) return;
#ifdef MUTANT_8  // inclusive
  const uint begin = min(before_block + through, params.capacity);
#else
  const uint begin = min(before_block + through - most_of(wanted), params.capacity);
#endif
  const uvec3 kept = min(wanted, uvec3(params.capacity - begin));
  cells[cell] = uvec2(begin, pack_cluster(kept));
  drop(wanted - kept);
  if (cell + 1u == cell_count()) list_status[0].entries = before_block + through;
}
