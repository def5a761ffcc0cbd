// Three floats in a word, red lowest: 5 bits of exponent over 6, 6 and 5 of mantissa, no sign.
#ifndef HARNESS_GLSL_R11G11B10
#define HARNESS_GLSL_R11G11B10
#include "harness/glsl/half.glsl"

const vec3 kLargestR11G11B10 = vec3(65024.0, 65024.0, 64512.0);  // (2 - 2^-kept) 2^15

uint encode_r11g11b10(vec3 radiance) {
#ifdef MUTANT_9816  // blue held at what red holds: rounds to infinity
  const vec3 c = held(radiance, kLargestR11G11B10.rrr);
#else
  const vec3 c = held(radiance, kLargestR11G11B10);
#endif
#ifdef MUTANT_9813  // blue as fine as the others
  return small_float(c.r, 6u) | small_float(c.g, 6u) << 11u | small_float(c.b, 6u) << 22u;
#else
  return small_float(c.r, 6u) | small_float(c.g, 6u) << 11u | small_float(c.b, 5u) << 22u;
#endif
}
vec3 decode_r11g11b10(uint code) {
  return vec3(small_float_value(code, 6u), small_float_value(code >> 11u, 6u), small_float_value(code >> 22u, 5u));
}
#endif
