#version 460
// A thread a cell: its items in order, the i-th of each kind in its i-th entry.
// Loop turns of an invocation: 256 entries, and 264 words between them.
#define READS_BITS
#include "kernels/cluster_lists/common.glsl"

layout(local_size_x = 64) in;
READS(3, uvec2, cells);
WRITES(4, uint, entries);

struct Walk {
  uint word;  // the next to read
  uint bits;  // of the one before, those not taken yet
};

uint next_item(uint kind, uint cell, inout Walk walk) {
  while (walk.bits == 0u && walk.word < word_count(kind)) walk.bits = word_at(kind, walk.word++, cell);
#ifdef MUTANT_9  // from the highest
  const uint bit = uint(findMSB(walk.bits));
#else
  const uint bit = uint(findLSB(walk.bits));
#endif
  walk.bits &= ~(1u << bit);
  return (walk.word - 1u) * 32u + bit;
}

void main() {
  const uint cell = gl_GlobalInvocationID.x;
  if (cell >= cell_count()) return;
  const uvec2 head = cells[cell];
  const uvec3 counts = unpack_cluster(head.y);
  Walk walks[kKinds];
  for (uint kind = 0u; kind < kKinds; ++kind) walks[kind] = Walk(0u, 0u);
  for (uint i = 0u; i < most_of(counts); ++i) {
    uvec3 items = uvec3(0u);
    for (uint kind = 0u; kind < kKinds; ++kind)
      if (i < counts[kind]) items[kind] = next_item(kind, cell, walks[kind]);
    entries[head.x + i] = pack_cluster(items);
  }
}
