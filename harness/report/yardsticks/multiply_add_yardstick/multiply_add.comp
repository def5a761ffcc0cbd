#version 460
#include "harness/glsl/ports.glsl"
#include "harness/report/yardsticks/multiply_add_yardstick/layout.h"

// Four chains hide the latency of one; factor and term come from memory so that nothing can be folded.
layout(local_size_x = kGroupSize) in;
WRITES(0, float, sums);
PARAMS(MultiplyAddParams);

void main() {
  uint at = gl_WorkGroupID.x * kGroupSize + gl_LocalInvocationIndex;
  vec4 a = vec4(0.25, 0.5, 0.75, 1.0);
  vec4 b = a + 1.0, c = a + 2.0, d = a + 3.0;
  for (uint i = 0u; i < kRounds; ++i) {
    a = a * params.factor + params.term;
    b = b * params.factor + params.term;
    c = c * params.factor + params.term;
    d = d * params.factor + params.term;
  }
  sums[at] = dot(a + b + c + d, vec4(1.0));
}
