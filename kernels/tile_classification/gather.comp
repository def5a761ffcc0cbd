#version 460
// One thread a tile: which workload of each pass takes the tile, appended to that workload's list. A group counts its
// tiles in shared memory and reserves a run of each list with one atomic. The counts are cleared before.
// Loop turns of an invocation: passes * workloads, at most 256.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 256) in;
READS(0, Workload, workloads);
READS(1, uint, masks);
WRITES(2, uint, workload_tiles);
UPDATES(3, WorkloadCount, workload_counts);
PARAMS(ClassifyParams);

shared uint tiles_here[kMaxWorkloads];   // of this group, a workload
shared uint first_entry[kMaxWorkloads];  // where the group's run begins in the workload's list

bool takes(Workload w, uint mask) {
#if defined(MUTANT_8)  // any required bit will do
  return (w.required == 0u || (mask & w.required) != 0u) && (mask & w.excluded) == 0u;
#elif defined(MUTANT_9)  // excluded bits do not exclude
  return (mask & w.required) == w.required;
#else
  return (mask & w.required) == w.required && (mask & w.excluded) == 0u;
#endif
}

uint workload_for(uint pass, uint mask, uint rows) {
#ifndef MUTANT_10  // empty tiles go to the default
  if ((mask & params.relevant[pass]) == 0u) return kNoWorkload;
#endif
  uint last = kNoWorkload;
  for (uint w = 0u; w < rows; ++w) {
    const Workload candidate = workloads[w];
    if (candidate.pass != pass) continue;
#ifdef MUTANT_11  // the last match wins
    if (last == kNoWorkload || takes(candidate, mask)) last = w;
#else
    last = w;
    if (takes(candidate, mask)) break;
#endif
  }
  return last;
}

void main() {
  const uint tiles = tile_count(uvec2(params.width, params.height));
  const uint rows = min(params.workloads, kMaxWorkloads);
  const uint tile = gl_GlobalInvocationID.x;
  const uint thread = gl_LocalInvocationID.x;
  if (thread < kMaxWorkloads) tiles_here[thread] = 0u;
  barrier();
  for (uint pass = 0u; pass < min(params.passes, kMaxPasses); ++pass) {  // no two passes share a row
    const uint w = tile < tiles ? workload_for(pass, masks[tile], rows) : kNoWorkload;
    uint slot = 0u;
#ifdef MUTANT_12  // a lost atomic
    if (w != kNoWorkload) slot = tiles_here[w]++;
#else
    if (w != kNoWorkload) slot = atomicAdd(tiles_here[w], 1u);
#endif
#ifndef MUTANT_13  // the barrier dropped: runs are reserved before the higher subgroups have counted
    barrier();
#endif
    if (thread < rows && workloads[thread].pass == pass)
      first_entry[thread] = atomicAdd(workload_counts[thread].tiles, tiles_here[thread]);
    barrier();
    if (w != kNoWorkload) workload_tiles[w * tiles + first_entry[w] + slot] = tile;
  }
}
