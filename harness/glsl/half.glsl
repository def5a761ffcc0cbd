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
#endif
