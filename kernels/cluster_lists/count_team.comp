#version 460
// 32 threads a cell, a word each at a time: for few cells of many items.
// Loop turns of an invocation: 4 words of a kind.
#define READS_BITS
#include "kernels/cluster_lists/common.glsl"
#include "kernels/cluster_lists/team.glsl"
WRITES(3, uvec2, cells);
#include "kernels/cluster_lists/counted.glsl"

shared uint found_by[kTeams][kKinds];

void main() {
  const uint team = gl_LocalInvocationID.x / kTeam, member = gl_LocalInvocationID.x % kTeam;
  const uint cell = gl_WorkGroupID.x * kTeams + team;
  if (member < kKinds) found_by[team][member] = 0u;
  barrier();
  if (cell < cell_count())
    for (uint kind = 0u; kind < kKinds; ++kind) {
      uint found = 0u;
      for (uint w = member; w < word_count(kind); w += kTeam) found += uint(bitCount(word_at(kind, w, cell)));
#ifdef MUTANT_4  // the atomic is lost
      found_by[team][kind] += found;
#else
      atomicAdd(found_by[team][kind], found);
#endif
    }
  barrier();
  if (cell < cell_count() && member == 0u)
    store_counts(cell, uvec3(found_by[team][0], found_by[team][1], found_by[team][2]));
}
