#version 460
#include "harness/glsl/ports.glsl"
#include "tests/planted/check_targets/layout.h"
PARAMS(TargetParams);
layout(location = 0) out uint colour;

void main() {
  const uint pixel = uint(gl_FragCoord.y) * params.width + uint(gl_FragCoord.x);
  if (pixel == params.hole) discard;
  colour = pixel + 100u;
}
