#version 460
// A thread an entry of the screen's list, numbered by subgroup. (Mesa 22.3 would reuse a shader of another width from its
// cache if nothing in it named the width.)
#include "harness/glsl/ports.glsl"
READS(4, uint, list);
READS(5, uint, list_count);
#define VRCS_LIST list
#define VRCS_LIST_COUNT list_count
#include "kernels/vrcs_remap/visit.glsl"

layout(local_size_x = kVrcsListGroup) in;

void main() {
#ifdef MUTANT_7  // one row of groups
  const uint first = gl_WorkGroupID.x * kVrcsListGroup;
#else
  const uint first = spread_group() * kVrcsListGroup;
#endif
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
#ifdef MUTANT_8  // the last thread of a group has nothing to do
  if (lane + 1u == kVrcsListGroup) return;
#endif
  const VrcsPixel p = vrcs_list_pixel(first + lane);
  if (p.code == kVrcsNoWork) return;
  count_wave(0u);
  vrcs_postfix(p, place_of(p.at));
}
