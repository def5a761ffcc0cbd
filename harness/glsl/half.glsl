// Small floats, rounded to nearest by hand: Vulkan leaves the rounding of its pack functions to the device, and
// truncation doubles the error.
#ifndef HARNESS_GLSL_HALF
#define HARNESS_GLSL_HALF
#ifdef MUTANT_9116  // truncates
#define TO_NEAREST trunc
#else
#define TO_NEAREST roundEven
#endif

// Five bits of exponent over `kept` of mantissa, as binary16 has them with ten, under a sign. For magnitudes up to
// 65,504.
uint small_float(float v, uint kept) {
  const uint bits = floatBitsToUint(v);
  // 113: 2^-14, below which the step stays as it is. The mantissa counts its leading 1, which moves the exponent on.
  const uint exponent = max(bits >> 23 & 255u, 113u);
  const uint mantissa = uint(TO_NEAREST(abs(v) * uintBitsToFloat((254u + kept - exponent) << 23)));
  return ((exponent - 113u) << kept) + mantissa | (bits >> 31) << (5u + kept);
}
uint binary16(float v) { return small_float(v, 10u); }

// Exact, without the sign. Codes of infinities and NaN are read as the numbers that would follow.
float small_float_value(uint code, uint kept) {
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

// Between 0, which NaN is too, and the largest.
float held(float v, float largest) {
#ifdef MUTANT_9811  // beyond the largest, whatever comes out
  return v > 0.0 ? v : 0.0;
#else
  return v > 0.0 ? min(v, largest) : 0.0;
#endif
}
vec3 held(vec3 v, vec3 largest) {
  return vec3(held(v.r, largest.r), held(v.g, largest.g), held(v.b, largest.b));
}
#endif
