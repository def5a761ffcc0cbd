#version 460
// Takes as long as it is told to: a stand-in for a loop that never ends. Nested, since lavapipe ends an invocation's loops
// after 65,535 turns in all; there it is the number of invocations that takes the time.
#include "harness/glsl/ports.glsl"
#include "tests/planted/check_hang/layout.h"

layout(local_size_x = 256) in;
WRITES(0, uint, ends);
PARAMS(HangParams);

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= params.count) return;
  uint word = i;
  for (uint turn = 0u; turn < params.turns; ++turn)
    for (uint inner = 0u; inner < params.turns; ++inner) word = word * 1664525u + 1013904223u ^ word >> 9;
  ends[i] = word;
}
