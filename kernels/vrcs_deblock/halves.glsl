// Texels of rgba16_float as two words, and their halves as floats, by hand: every half is exact, subnormal ones too.

const float kLeastHalf = 5.9604644775390625e-8;  // 2^-24

// `half_bits` may be NaN or infinite, and is so as a float.
float from_half(uint half_bits) {
  const uint sign = half_bits & 0x8000u, magnitude = half_bits & 0x7fffu;
  if (magnitude < 0x400u) return (sign != 0u ? -kLeastHalf : kLeastHalf) * float(magnitude);
  const uint rebias = magnitude < 0x7c00u ? 127u - 15u : 255u - 31u;
  return uintBitsToFloat(sign << 16 | (magnitude << 13) + (rebias << 23));
}

vec3 colour_of(uvec2 texel) {
  return vec3(from_half(texel.x & 0xffffu), from_half(texel.x >> 16), from_half(texel.y & 0xffffu));
}
bool is_finite(uvec2 texel) {
  const uint exponent = 0x7c00u;
  return (texel.x & exponent) != exponent && (texel.x >> 16 & exponent) != exponent && (texel.y & exponent) != exponent;
}
