#version 460
// The dispatch over the list, once it is complete: a group a tile.
#include "harness/glsl/ports.glsl"
#include "kernels/decal_tiles/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 1) in;
UPDATES(3, uint, count);
WRITES(6, DispatchArgs, args);

void main() {
#ifdef MUTANT_10  // the last tile has no group
  const uvec2 groups = spread(count[0] - min(count[0], 1u));
#else
  const uvec2 groups = spread(count[0]);
#endif
  args[0] = DispatchArgs(groups.x, groups.y, 1u);
}
