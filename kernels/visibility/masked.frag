#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "harness/glsl/cut.glsl"

layout(location = 0) flat in uint word;
layout(location = 1) flat in uint material;
layout(location = 2) in vec2 uv;
layout(location = 0) out uvec2 visibility;

void main() {
  if (is_hole(material, uv)) discard;
#ifdef MUTANT_11
  visibility = uvec2(gl_PrimitiveID + 1, word);
#else
  visibility = uvec2(gl_PrimitiveID, word);
#endif
}
