// Half floats (IEEE 754 binary16) on the host, by their definition; exact in double. Host only.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace assay {

constexpr double kLargestHalf = 65504;

inline double half_value(uint16_t bits) {
  const double sign = (bits & 0x8000u) != 0 ? -1 : 1;
  const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
  if (exponent == 31)
    return mantissa != 0 ? std::numeric_limits<double>::quiet_NaN() : sign * std::numeric_limits<double>::infinity();
  return exponent == 0 ? sign * std::ldexp(mantissa, -24) : sign * std::ldexp(1024 + mantissa, exponent - 25);
}

// The distance between halves about |v|.
inline double half_step(double v) {
  if (v == 0) return 0x1p-24;
  int exponent = 0;
  std::frexp(v, &exponent);  // |v| in [2^(exponent-1), 2^exponent)
  return std::ldexp(1.0, std::max(exponent - 1, -14) - 10);
}
// The nearest finite halves on either side, or v itself where it is one.
inline double half_at_most(double v) {
  if (!(v > -kLargestHalf)) return -kLargestHalf;
  return v >= kLargestHalf ? kLargestHalf : std::floor(v / half_step(v)) * half_step(v);
}
inline double half_at_least(double v) { return -half_at_most(-v); }

// The bits of a half's value.
inline uint16_t half_bits(double value) {
  const auto sign = static_cast<uint16_t>(std::signbit(value) ? 0x8000u : 0u);
  if (std::isnan(value)) return 0x7e00;
  if (std::isinf(value)) return static_cast<uint16_t>(sign | 0x7c00u);
  const double magnitude = std::fabs(value), step = half_step(magnitude);
  const auto steps = static_cast<uint32_t>(magnitude / step);  // exponent and mantissa run on
  const int exponent = std::ilogb(step) + 24;                  // 0 for denormals and the first binade
  return static_cast<uint16_t>(sign | (static_cast<uint32_t>(exponent) * 1024 + steps));
}

// The nearest finite half, of two as near the even one; NaN and infinities as they are.
inline uint16_t nearest_half(double v) {
  if (!std::isfinite(v)) return half_bits(v);
  const double low = half_at_most(v), high = half_at_least(v), below = v - low, above = high - v;
  const bool even_low = half_bits(low) % 2 == 0;
  return half_bits(below < above || (below == above && even_low) ? low : high);
}

}  // namespace assay
