#version 460
#include "harness/glsl/ports.glsl"
#include "harness/report/yardsticks/copy_yardstick/layout.h"

// Each thread moves VECTORS vectors, a workgroup apart, so that neighbours in a wave touch neighbours in memory.
layout(constant_id = 0) const uint VECTORS = 1;
layout(local_size_x = 256) in;
READS(0, uvec4, source);
WRITES(1, uvec4, target);
PARAMS(CopyParams);

void main() {
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint first = group * 256u * VECTORS + gl_LocalInvocationIndex;
  for (uint i = 0u; i < VECTORS; ++i) {
    uint at = first + i * 256u;
    if (at < params.vectors) target[at] = source[at];
  }
}
