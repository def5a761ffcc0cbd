#version 460
#include "harness/glsl/ports.glsl"
#include "tests/planted/device_copy/layout.h"
layout(local_size_x_id = 0) in;
layout(constant_id = 0) const uint GROUP = 64;
layout(constant_id = 1) const uint SCALE = 1;
layout(constant_id = 2) const uint SUBGROUP_SIZE = 0;
READS(0, Pair, pairs);
WRITES(1, Pair, copies);
PARAMS(CopyParams);

void main() {
  const uint i = gl_WorkGroupID.x * 64 + gl_LocalInvocationID.x;
  for (uint j = i; j < min(gl_WorkGroupID.x * 64 + 64, params.count); j += GROUP) {
    copies[j] = pairs[j];
    copies[j].key = pairs[j].key * SCALE + params.add;
    copies[j].weights[1] = float(SUBGROUP_SIZE);
  }
}
