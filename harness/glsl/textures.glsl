// The scene's array textures, 16 slots at most (formats/material.h names a texture array << 16 | layer). Slots are chosen by
// a switch with constant indices: no device has to index an array of samplers dynamically. A name past the slots reads
// white, as does an unused slot (the harness fills those with one white texel); a layer past the array's end is the
// last one, by Vulkan's clamp. Define TEXTURES_SLOT, the binding, before including.
#ifndef HARNESS_GLSL_TEXTURES
#define HARNESS_GLSL_TEXTURES
#include "harness/formats/material.h"

layout(binding = TEXTURES_SLOT) uniform sampler2DArray textures[16];

#define ASSAY_EACH_TEXTURE(ONE)                                                                           \
  ONE(0) ONE(1) ONE(2) ONE(3) ONE(4) ONE(5) ONE(6) ONE(7) ONE(8) ONE(9) ONE(10) ONE(11) ONE(12) ONE(13) \
  ONE(14) ONE(15)

// At an explicit level, which makes the answer independent of neighbouring pixels: passes that cut holes use level 0, so
// that visibility, shadows and baselines cut the same ones.
vec4 texture_at_level(uint name, vec2 uv, float level) {
  if (name == kNoTexture) return vec4(1);
  vec3 at = vec3(uv, float(name & 0xffffu));
  switch (name >> 16) {
#define ASSAY_ONE_TEXTURE(i) \
  case i: return textureLod(textures[i], at, level);
    ASSAY_EACH_TEXTURE(ASSAY_ONE_TEXTURE)
#undef ASSAY_ONE_TEXTURE
  }
  return vec4(1);
}

vec4 texture_with_gradients(uint name, vec2 uv, vec2 d_dx, vec2 d_dy) {
  if (name == kNoTexture) return vec4(1);
  vec3 at = vec3(uv, float(name & 0xffffu));
  switch (name >> 16) {
#define ASSAY_ONE_TEXTURE(i) \
  case i: return textureGrad(textures[i], at, d_dx, d_dy);
    ASSAY_EACH_TEXTURE(ASSAY_ONE_TEXTURE)
#undef ASSAY_ONE_TEXTURE
  }
  return vec4(1);
}
#endif
