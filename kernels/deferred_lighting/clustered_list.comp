#version 460
// A thread a primary of the screen's list: no wave is launched but one without work, and background.comp sees to the
// pixels that no list has.
#include "kernels/deferred_lighting/cell_lights.glsl"
#define VRCS_LIST list
#define VRCS_LIST_COUNT list_count
READS(11, uint, list);
READS(12, uint, list_count);
#include "kernels/deferred_lighting/primaries.glsl"

layout(local_size_x = kVrcsListGroup) in;

void main() {
#ifdef MUTANT_23  // one row of groups
  const uint first = gl_WorkGroupID.x * kVrcsListGroup;
#else
  const uint first = spread_group() * kVrcsListGroup;
#endif
#ifdef MUTANT_24  // the last thread of a group has nothing to do
  if (gl_LocalInvocationIndex + 1u == kVrcsListGroup) return;
#endif
  const VrcsPixel p = vrcs_list_pixel(first + gl_LocalInvocationIndex);
  if (p.code == kVrcsWork) shade_primary(p);
}
