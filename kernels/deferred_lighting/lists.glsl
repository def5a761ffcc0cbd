// The lights of a pixel's cell, by list.
#include "kernels/deferred_lighting/common.glsl"

READS(8, uvec2, cells);
READS(9, uint, entries);
READS(10, float, slice_edges);
#include "harness/glsl/clusters.glsl"

struct List {
  uint first;
  uint count;
};

const List kNoList = List(0u, 0u);

uint cell_at(uvec2 pixel, float d) { return cell_of(params.grid, pixel, d); }

// Without cells there are no lists; what lies past the last entry is in none.
List list_of(uint cell) {
  if (params.grid.columns == 0u || params.grid.rows == 0u) return kNoList;
  const uvec2 head = cells[cell];
  const uint first = min(head.x, params.entries);
  const uint count = min(unpack_cluster(head.y).x, min(kMaxClusterEntries, params.entries - first));
  return List(first, count);
}

// An index past the last light sheds none.
uint light_in(uint entry) { return unpack_cluster(entries[entry]).x; }
void add_light(inout Lit lit, uint light) {
#ifdef MUTANT_14  // the last light is not there
  if (light + 1u < light_count()) lit.radiance += lit_by(lit, lights[light]);
#else
  if (light < light_count()) lit.radiance += lit_by(lit, lights[light]);
#endif
}
