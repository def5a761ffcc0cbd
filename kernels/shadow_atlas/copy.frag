#version 460
#include "harness/glsl/ports.glsl"

layout(binding = 0) uniform texture2D still;

void main() {
#ifdef MUTANT_12
  gl_FragDepth = 0;
#else
  gl_FragDepth = texelFetch(still, ivec2(gl_FragCoord.xy), 0).x;
#endif
}
