// Floats as halves, by hand: to the nearest even, which neither stores nor packHalf2x16 promise.

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

uvec2 with_colour(uvec2 texel, vec3 colour) {
#ifdef MUTANT_2  // red and green swapped
  return uvec2(to_half(colour.r) << 16 | to_half(colour.g), (texel.y & 0xffff0000u) | to_half(colour.b));
#else
  return uvec2(to_half(colour.g) << 16 | to_half(colour.r), (texel.y & 0xffff0000u) | to_half(colour.b));
#endif
}
