#version 460
// The indirect dispatches over the two lists: a group a tile, spread over x and y.
#include "harness/glsl/ports.glsl"
#include "kernels/edge_classification/layout.h"
#include "harness/glsl/tiles.glsl"

layout(local_size_x = 2) in;
READS(0, uint, tile_counts);
WRITES(1, DispatchArgs, args);

void main() {
  const uint list = gl_LocalInvocationID.x;
#ifdef MUTANT_14  // one dimension only: the tiles past its limit are lost
  const uvec2 groups = uvec2(min(tile_counts[list], kMaxGroups), min(tile_counts[list], 1u));
#else
  const uvec2 groups = spread(tile_counts[list]);
#endif
  args[list] = DispatchArgs(groups.x, groups.y, 1u);
}
