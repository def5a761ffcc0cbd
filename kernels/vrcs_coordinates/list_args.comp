#version 460
// The dispatch over the screen's list, once it is complete: a thread an entry.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_coordinates/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 1) in;
UPDATES(0, uint, list_count);
WRITES(1, DispatchArgs, list_args);

void main() {
#ifdef MUTANT_20  // the last group is not full, and not there
  const uvec2 groups = spread(list_count[0] / kVrcsListGroup);
#else
  const uvec2 groups = spread(ceil_div(list_count[0], kVrcsListGroup));
#endif
  list_args[0] = DispatchArgs(groups.x, groups.y, 1u);
}
