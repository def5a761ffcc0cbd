// Radiance in 32 or 64 bits (kLight... of harness/formats/particle.h). What is not above 0 is 0, NaN too; what is above
// an encoding's largest number is that. All round to nearest by hand: Vulkan leaves the rounding of a store to the
// device, and truncation doubles the error and darkens by 0.6 % (kernels/radiance_encodings/README.md).
#ifndef HARNESS_GLSL_RADIANCE_ENCODINGS
#define HARNESS_GLSL_RADIANCE_ENCODINGS
#include "harness/formats/particle.h"
#include "harness/glsl/gbuffer.glsl"
#include "harness/glsl/half.glsl"

// (2 - 2^-kept) 2^15 of 6 and 5 bits of mantissa; the largest half.
const vec3 kLargestR11G11B10 = vec3(65024.0, 65024.0, 64512.0);
const vec3 kLargestRgba16 = vec3(65504.0);

float between_0_and(float largest, float v) {
#ifdef MUTANT_9811  // beyond the largest, whatever comes out
  return v > 0.0 ? v : 0.0;
#else
  return v > 0.0 ? min(v, largest) : 0.0;
#endif
}
vec3 between_0_and(vec3 largest, vec3 v) {
  return vec3(between_0_and(largest.r, v.r), between_0_and(largest.g, v.g), between_0_and(largest.b, v.b));
}

// Red lowest: 5 bits of exponent over 6, 6 and 5 of mantissa, no sign.
uint encode_r11g11b10(vec3 radiance) {
#ifdef MUTANT_9816  // blue held at what red holds: rounds to infinity
  const vec3 c = between_0_and(kLargestR11G11B10.rrr, radiance);
#else
  const vec3 c = between_0_and(kLargestR11G11B10, radiance);
#endif
#ifdef MUTANT_9813  // blue as fine as the others
  return small_float(c.r, 6u) | small_float(c.g, 6u) << 11u | small_float(c.b, 6u) << 22u;
#else
  return small_float(c.r, 6u) | small_float(c.g, 6u) << 11u | small_float(c.b, 5u) << 22u;
#endif
}
// Red, green, blue, and an alpha of 1.
uvec2 encode_rgba16(vec3 radiance) {
  const vec3 c = between_0_and(kLargestRgba16, radiance);
#ifdef MUTANT_9814  // an alpha of 0
  return uvec2(binary16(c.r) | binary16(c.g) << 16u, binary16(c.b));
#else
  return uvec2(binary16(c.r) | binary16(c.g) << 16u, binary16(c.b) | 0x3c000000u);
#endif
}

// Exact. Codes of infinities and NaN are read as the numbers that would follow.
float decode_small_float(uint code, uint kept) {
  const uint exponent = code >> kept & 31u, mantissa = code & ((1u << kept) - 1u);
#ifdef MUTANT_9812  // denormal numbers have a leading 1 too
  const uint lead = 1u << kept;
#else
  const uint lead = exponent == 0u ? 0u : 1u << kept;
#endif
#ifdef MUTANT_9815  // steps below 2^-14 become finer still
  return float(lead + mantissa) * uintBitsToFloat((exponent + 112u - kept) << 23u);
#else
  return float(lead + mantissa) * uintBitsToFloat((max(exponent, 1u) + 112u - kept) << 23u);
#endif
}
vec3 decode_r11g11b10(uint code) {
  return vec3(decode_small_float(code, 6u), decode_small_float(code >> 11u, 6u), decode_small_float(code >> 22u, 5u));
}
vec3 decode_rgba16(uvec2 code) {
  return vec3(decode_small_float(code.x, 10u), decode_small_float(code.x >> 16u, 10u), decode_small_float(code.y, 10u));
}

// Of the encodings that fit a word; `encoding` is one of them.
uint encode_radiance(vec3 radiance, uint encoding) {
  return encoding == kLightRgb9e5 ? encode_shared_exponent(radiance) : encode_r11g11b10(radiance);
}
vec3 decode_radiance(uint code, uint encoding) {
  return encoding == kLightRgb9e5 ? decode_shared_exponent(code) : decode_r11g11b10(code);
}
#endif
