// Four halves in two words: red, green, blue, and an alpha of 1.
#ifndef HARNESS_GLSL_RGBA16
#define HARNESS_GLSL_RGBA16
#include "harness/glsl/half.glsl"

uvec2 encode_rgba16(vec3 radiance) {
  const vec3 c = held(radiance, vec3(65504.0));
#ifdef MUTANT_9814  // an alpha of 0
  return uvec2(binary16(c.r) | binary16(c.g) << 16u, binary16(c.b));
#else
  return uvec2(binary16(c.r) | binary16(c.g) << 16u, binary16(c.b) | 0x3c000000u);
#endif
}
vec3 decode_rgba16(uvec2 code) {
  return vec3(small_float_value(code.x, 10u), small_float_value(code.x >> 16u, 10u), small_float_value(code.y, 10u));
}
#endif
