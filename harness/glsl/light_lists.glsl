// The lights that a cell lists (harness/formats/cluster_lists.h). Before including, a shader declares `cells`, `entries`
// and `params` with a grid and how many entries there are, a struct Lit, and what a light of this number does to it:
// void add_light(inout Lit, uint light). An index past the last light must do nothing.
#ifndef HARNESS_GLSL_LIGHT_LISTS
#define HARNESS_GLSL_LIGHT_LISTS
#include "harness/formats/cluster_lists.h"

struct List {
  uint first;
  uint count;
};

const List kNoList = List(0u, 0u);

// Without cells there are no lists; what lies past the last entry is in none.
List list_of(uint cell) {
  if (params.grid.columns == 0u || params.grid.rows == 0u) return kNoList;
  const uvec2 head = cells[cell];
  const uint first = min(head.x, params.entries);
  const uint count = min(unpack_cluster(head.y).x, min(kMaxClusterEntries, params.entries - first));
  return List(first, count);
}
uint light_in(uint entry) { return unpack_cluster(entries[entry]).x; }
#endif
