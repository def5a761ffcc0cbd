// Texels of rgba16_float as two words, and their halves as floats and back, by hand: every half is exact, subnormal ones
// too, and rounding is to the nearest even, which neither stores nor packHalf2x16 promise.

const float kLeastHalf = 5.9604644775390625e-8;  // 2^-24

// `half_bits` may be NaN or infinite, and is so as a float.
float from_half(uint half_bits) {
  const uint sign = half_bits & 0x8000u, magnitude = half_bits & 0x7fffu;
  if (magnitude < 0x400u) return (sign != 0u ? -kLeastHalf : kLeastHalf) * float(magnitude);
  const uint rebias = magnitude < 0x7c00u ? 127u - 15u : 255u - 31u;
  return uintBitsToFloat(sign << 16 | (magnitude << 13) + (rebias << 23));
}

// Of -65504 to 65504; zeros are +0.
uint to_half(float v) {
  const uint sign = v < 0.0 ? 0x8000u : 0u, magnitude = floatBitsToUint(v) & 0x7fffffffu;
  if (magnitude < 0x38800000u) return sign | uint(roundEven(abs(v) * 16777216.0));  // below 2^-14: steps of 2^-24
#ifdef MUTANT_1  // truncated
  return sign | (magnitude - (112u << 23)) >> 13;
#else
  return sign | (magnitude - (112u << 23) + 0xfffu + (magnitude >> 13 & 1u)) >> 13;
#endif
}

vec3 colour_of(uvec2 texel) {
  return vec3(from_half(texel.x & 0xffffu), from_half(texel.x >> 16), from_half(texel.y & 0xffffu));
}
uvec2 with_colour(uvec2 texel, vec3 colour) {
#ifdef MUTANT_2  // red and green swapped
  return uvec2(to_half(colour.r) << 16 | to_half(colour.g), (texel.y & 0xffff0000u) | to_half(colour.b));
#else
  return uvec2(to_half(colour.g) << 16 | to_half(colour.r), (texel.y & 0xffff0000u) | to_half(colour.b));
#endif
}
bool is_finite(uvec2 texel) {
  const uint exponent = 0x7c00u;
  return (texel.x & exponent) != exponent && (texel.x >> 16 & exponent) != exponent && (texel.y & exponent) != exponent;
}
