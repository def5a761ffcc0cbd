#version 460
// 32 threads a cell: each takes a word, and finds where its items go from how many the words before hold.
// Loop turns of an invocation: 4 words of a kind with 32 bits each, the steps of a scan, 8 entries.
#define READS_BITS
#include "kernels/cluster_lists/common.glsl"
#include "kernels/cluster_lists/team.glsl"
READS(3, uvec2, cells);
WRITES(4, uint, entries);
#include "harness/glsl/scan.glsl"

shared uint list[kTeams][kMaxClusterEntries];

void main() {
  const uint team = gl_LocalInvocationID.x / kTeam, member = gl_LocalInvocationID.x % kTeam;
  const uint cell = gl_WorkGroupID.x * kTeams + team;
  const bool is_cell = cell < cell_count();
  const uvec2 head = is_cell ? cells[cell] : uvec2(0u);
  const uvec3 counts = unpack_cluster(head.y);
  for (uint i = member; i < kMaxClusterEntries; i += kTeam) list[team][i] = 0u;
  barrier();
  for (uint kind = 0u; kind < kKinds; ++kind) {
    uint before = 0u;
    for (uint first = 0u; first < word_count(kind); first += kTeam) {  // the same for all of the group
      const uint w = first + member;
      uint bits = is_cell && w < word_count(kind) ? word_at(kind, w, cell) : 0u;
      uint of_round;
      const uint own = uint(bitCount(bits)), through = sum_through(own, of_round);
      uint at = before + through - own;
      for (; bits != 0u && at < counts[kind]; ++at, bits &= bits - 1u) {
        uvec3 items = uvec3(0u);
        items[kind] = w * 32u + uint(findLSB(bits));
#ifdef MUTANT_10  // the last kind alone is left
        list[team][at] = pack_cluster(items);
#else
        atomicOr(list[team][at], pack_cluster(items));
#endif
      }
#ifndef MUTANT_11  // each round of words begins at the front again
      before += of_round;
#endif
    }
  }
  barrier();
  for (uint i = member; i < most_of(counts); i += kTeam) entries[head.x + i] = list[team][i];
}
