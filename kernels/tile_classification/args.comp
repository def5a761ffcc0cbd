#version 460
// One group: the indirect dispatch of each workload, then the figures of each pass.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 32) in;  // kMaxWorkloads
READS(0, Workload, workloads);
UPDATES(1, WorkloadCount, workload_counts);
WRITES(2, DispatchArgs, workload_args);
WRITES(3, PassStatistics, statistics);
PARAMS(ClassifyParams);

uint saturating_product(uint a, uint b) {
  uint high, low;
  umulExtended(a, b, high, low);
#ifdef MUTANT_14  // wraps
  return low;
#else
  return high != 0u ? 0xffffffffu : low;
#endif
}

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const uint rows = min(params.workloads, kMaxWorkloads);
  const uint groups = min(params.groups_per_tile, kMaxGroups);
  if (thread < rows) {
    const uint tiles = workload_counts[thread].tiles;
#ifdef MUTANT_15  // one dimension only: the tiles past its limit are lost
    const uvec2 list = uvec2(min(tiles, kMaxGroups), min(tiles, 1u));
#else
    const uvec2 list = spread(tiles);
#endif
    workload_args[thread] = DispatchArgs(groups, list.x, list.y);
    workload_counts[thread].groups = saturating_product(tiles, groups);
  }
  if (thread >= min(params.passes, kMaxPasses)) return;
  const uint everywhere = tile_count(uvec2(params.width, params.height));
  uint taken = 0u;
  for (uint w = 0u; w < rows; ++w)
#ifdef MUTANT_16  // sums the other passes too
    taken += workload_counts[w].tiles;
#else
    if (workloads[w].pass == thread) taken += workload_counts[w].tiles;
#endif
  statistics[thread] = PassStatistics(saturating_product(everywhere, groups), saturating_product(taken, groups),
                                      saturating_product(everywhere - taken, groups));
}
