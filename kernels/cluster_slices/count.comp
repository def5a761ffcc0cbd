#version 460
// Each boundary is asked: as many comparisons as slices, none waits for another.
#include "kernels/cluster_slices/common.glsl"

uint slice_at(float d) {
  uint beyond = 0u;
#if defined(MUTANT_3)  // the last slice's beginning is not asked
  for (uint k = 1u; k + 1u < params.grid.slices; ++k)
#elif defined(MUTANT_5)  // the first boundary counts too
  for (uint k = 0u; k < params.grid.slices; ++k)
#else
  for (uint k = 1u; k < params.grid.slices; ++k)
#endif
#ifdef MUTANT_4  // < for <=
    beyond += uint(d < slice_edges[k]);
#else
    beyond += uint(d <= slice_edges[k]);
#endif
  return beyond;
}
