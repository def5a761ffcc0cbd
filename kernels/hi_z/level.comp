#version 460
// A thread a texel of one level, from the level below. The dispatch has as many rows of groups as the level's number:
// that is how a thread knows it.
#include "kernels/hi_z/common.glsl"

layout(local_size_x = 256) in;

void main() {
  const uint level = gl_NumWorkGroups.y, i = spread_group() * 256u + gl_LocalInvocationID.x;
  const uvec2 size = size_of(level);
  const uvec2 at = uvec2(i % size.x, i / size.x);
  if (at.y >= size.y) return;
  store(level, at, range_below(level, at));
}
