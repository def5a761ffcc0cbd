// The lights of a pixel's cell, by list.
#include "kernels/deferred_lighting/common.glsl"

READS(8, uvec2, cells);
READS(9, uint, entries);
READS(10, float, slice_edges);
#include "harness/glsl/clusters.glsl"

uint cell_at(uvec2 pixel, float d) { return cell_of(params.grid, pixel, d); }

void add_light(inout Lit lit, uint light) {
#ifdef MUTANT_14  // the last light is not there
  if (light + 1u < light_count()) lit.radiance += lit_by(lit, lights[light]);
#else
  if (light < light_count()) lit.radiance += lit_by(lit, lights[light]);
#endif
}
