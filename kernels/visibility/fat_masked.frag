#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "harness/glsl/cut.glsl"
#include "kernels/visibility/fat.glsl"

layout(location = 0) flat in uint word;
layout(location = 0) out uvec2 visibility;

void main() {
  uvec2 texel = fat_texel();  // before the cut: the quad's other pixels are still there
  if (is_hole(material_and_hand & ~kNegativeHand, uv)) discard;
#ifdef MUTANT_17
  visibility = uvec2(gl_PrimitiveID + 1, word);
#else
  visibility = uvec2(gl_PrimitiveID, word);
#endif
  fat = texel;
}
