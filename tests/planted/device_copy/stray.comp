#version 460
#include "harness/glsl/ports.glsl"
#include "tests/planted/device_copy/layout.h"
layout(local_size_x = 64) in;
WRITES(0, Pair, copies);
PARAMS(CopyParams);

void main() {
  if (gl_GlobalInvocationID.x == 0) copies[params.count].key = 0xbad;
}
