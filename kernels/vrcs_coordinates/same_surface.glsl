// Pixels of one surface share where it is continuous: the talk's proposal in place of triangles.
#include "kernels/vrcs_coordinates/depths.glsl"

void prepare_sharing(uint tile) {}

bool shares_across(Cell cell, uint a, uint b) {
#ifdef MUTANT_16  // flags of the surface tell surfaces apart
  const bool same = cell.seen[a].y == cell.seen[b].y;
#else
  const bool same = ((cell.seen[a].y ^ cell.seen[b].y) & kVisibilitySurfaceMask) == 0u;
#endif
  return same && close_depths(cell.depth[a], cell.depth[b]);
}
