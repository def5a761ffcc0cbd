#include "harness/radiance_oracle.h"

#include "harness/half.h"

namespace assay::radiance {

using glm::dvec3;

namespace {

constexpr double kLargestShared = 65408;  // 511 2^7

// A float of 5 bits of exponent, bias 15, over `kept` of mantissa; no sign.
double largest_small(int kept) { return std::ldexp(2 - std::ldexp(1.0, -kept), 15); }
double small_step(double v, int kept) {
  int exponent = -13;
  if (v > 0) std::frexp(v, &exponent);  // v in [2^(exponent-1), 2^exponent)
  return std::ldexp(1.0, std::max(exponent - 1, -14) - kept);
}
// To even where two are as near; the steps of a binade's end are whole numbers of the next one's half.
double nearest_small(double v, int kept) {
  if (!(v > 0)) return 0;
  if (v >= largest_small(kept)) return largest_small(kept);
  const double step = small_step(v, kept), whole = std::floor(v / step), part = v / step - whole;
  const bool up = part > 0.5 || (part == 0.5 && std::fmod(whole, 2) != 0);
  return (whole + (up ? 1 : 0)) * step;
}
uint32_t small_code(double v, int kept) {
  const double step = small_step(v, kept);
  const auto steps = static_cast<uint32_t>(v / step);
  return static_cast<uint32_t>(std::ilogb(step) + 14 + kept) * (1u << kept) + steps;
}
double small_value(uint32_t code, int kept) {
  const int exponent = static_cast<int>(code >> kept & 31);
  const double mantissa = code & ((1u << kept) - 1);
  const double lead = exponent == 0 ? 0 : std::ldexp(1.0, kept);
  return std::ldexp(lead + mantissa, std::max(exponent, 1) - 15 - kept);
}

struct Mantissas {
  int of[3];
};
constexpr Mantissas kKeptR11G11B10 = {{6, 6, 5}}, kKeptRgba16 = {{10, 10, 10}};
Mantissas kept_of(uint32_t encoding) { return encoding == kLightRgba16 ? kKeptRgba16 : kKeptR11G11B10; }

double held(double v) { return v > 0 ? std::min(v, kLargestShared) : 0; }
double rounded_up_at_half(double v) { return std::floor(v) + (v - std::floor(v) >= 0.5 ? 1 : 0); }
// The exponent under which the largest of three has 9 bits, once it is rounded.
int shared_exponent(double most) {
  int exponent = 0;
  if (most > 0) exponent = std::max(std::ilogb(most), -16) + 16;
  return rounded_up_at_half(std::ldexp(most, 24 - exponent)) > 511 ? exponent + 1 : exponent;
}

}  // namespace

dvec3 decoded(uvec2 code, uint32_t encoding) {
  if (encoding == kLightRgb9e5)
    return dvec3(code.x & 511u, code.x >> 9 & 511u, code.x >> 18 & 511u) *
           std::ldexp(1.0, static_cast<int>(code.x >> 27) - 24);
  if (encoding == kLightRgba16)
    return {small_value(code.x & 0x7fffu, 10), small_value(code.x >> 16 & 0x7fffu, 10),
            small_value(code.y & 0x7fffu, 10)};
  return {small_value(code.x & 0x7ffu, 6), small_value(code.x >> 11 & 0x7ffu, 6), small_value(code.x >> 22, 5)};
}

uvec2 encoded(const dvec3& colour, uint32_t encoding) {
  if (encoding == kLightRgb9e5) {
    const dvec3 c = {held(colour.x), held(colour.y), held(colour.z)};
    const int exponent = shared_exponent(std::max({c.x, c.y, c.z}));
    uint32_t word = static_cast<uint32_t>(exponent) << 27;
    for (int i = 0; i < 3; ++i)
      word |= static_cast<uint32_t>(rounded_up_at_half(std::ldexp(c[i], 24 - exponent))) << 9 * i;
    return {word, 0};
  }
  const Mantissas kept = kept_of(encoding);
  uint32_t code[3];
  for (int i = 0; i < 3; ++i) code[i] = small_code(nearest_small(colour[i], kept.of[i]), kept.of[i]);
  if (encoding == kLightRgba16) return {code[0] | code[1] << 16, code[2] | 0x3c000000u};
  return {code[0] | code[1] << 11 | code[2] << 22, 0};
}

namespace {

// Of each exponent that the largest channel may call for.
Stored stored_shared(const Intervals3& c) {
  const auto most = [&c](double Interval::*end) { return held(std::max({c[0].*end, c[1].*end, c[2].*end})); };
  Stored s = {dvec3(kLargestShared), dvec3(0)};
  for (int e = shared_exponent(most(&Interval::low)); e <= shared_exponent(most(&Interval::high)); ++e)
    for (int i = 0; i < 3; ++i) {
      const auto at = [e](double v) {
        return std::ldexp(std::min(rounded_up_at_half(std::ldexp(held(v), 24 - e)), 511.0), e - 24);
      };
      const Interval& channel = c[static_cast<size_t>(i)];
      s.low[i] = std::min(s.low[i], at(channel.low)), s.high[i] = std::max(s.high[i], at(channel.high));
    }
  return s;
}

}  // namespace

Stored stored(const Intervals3& c, uint32_t encoding) {
  if (encoding == kLightRgb9e5) return stored_shared(c);
  Stored s;
  for (int i = 0; i < 3; ++i) {
    const Interval& channel = c[static_cast<size_t>(i)];
    const int kept = kept_of(encoding).of[i];
    s.low[i] = nearest_small(channel.low, kept), s.high[i] = nearest_small(channel.high, kept);
  }
  return s;
}

}  // namespace assay::radiance
