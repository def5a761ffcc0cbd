#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "kernels/visibility/fat.glsl"

layout(early_fragment_tests) in;
layout(location = 0) flat in uint word;
layout(location = 0) out uvec2 visibility;

void main() {
#ifdef MUTANT_16
  visibility = uvec2(gl_PrimitiveID + 1, word);
#else
  visibility = uvec2(gl_PrimitiveID, word);
#endif
  fat = fat_texel();
}
