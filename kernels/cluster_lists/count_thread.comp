#version 460
// A thread a cell: how many of each kind it has.
// Loop turns of an invocation: the words of each kind, 264 at most.
#define READS_BITS
#include "kernels/cluster_lists/common.glsl"

layout(local_size_x = 64) in;
WRITES(3, uvec2, cells);
#include "kernels/cluster_lists/counted.glsl"

void main() {
  const uint cell = gl_GlobalInvocationID.x;
  if (cell >= cell_count()) return;
  uvec3 found = uvec3(0u);
  for (uint kind = 0u; kind < kKinds; ++kind)
    for (uint w = 0u; w < word_count(kind); ++w) found[kind] += uint(bitCount(word_at(kind, w, cell)));
  store_counts(cell, found);
}
