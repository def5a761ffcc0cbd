// The bits of cells (kernels/cluster_voxelization), kind by kind.
#include "harness/glsl/ports.glsl"
#include "kernels/cluster_lists/layout.h"

PARAMS(ListParams);

const uint kKinds = 3u;  // lights, decals, probes

uint cell_count() { return min(params.cells, kMaxCells); }
uvec3 item_counts() {
  return min(uvec3(params.lights, params.decals, params.probes),
             uvec3(kMaxClusterLights, kMaxClusterDecals, kMaxClusterProbes));
}
uint word_count(uint kind) { return (item_counts()[kind] + 31u) / 32u; }
// An entry has room for these many of each.
#ifdef MUTANT_1  // 256 probes, whose count of 8 bits is then 0
uvec3 most_in_a_cell() { return uvec3(kMaxClusterEntries); }
#else
uvec3 most_in_a_cell() { return uvec3(kMaxClusterEntries, kMaxClusterEntries, kMaxClusterEntries - 1u); }
#endif
uint most_of(uvec3 counts) { return max(counts.x, max(counts.y, counts.z)); }

#ifdef READS_BITS
READS(0, uint, light_bits);  // word after word, of each all cells
READS(1, uint, decal_bits);
READS(2, uint, probe_bits);

// Without the bits past the last item.
uint word_at(uint kind, uint word, uint cell) {
  const uint at = word * cell_count() + cell;
  const uint bits = kind == 0u ? light_bits[at] : kind == 1u ? decal_bits[at] : probe_bits[at];
  const uint left = item_counts()[kind] - word * 32u;
#ifdef MUTANT_2  // the last word's other bits are items
  return bits;
#else
  return left < 32u ? bits & ((1u << left) - 1u) : bits;
#endif
}
#endif
