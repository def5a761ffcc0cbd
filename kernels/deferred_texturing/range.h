// What a device may compute: interval arithmetic in double, each operation widened by what Vulkan allows fp32 to lose.
// Formulas written in it read like the technique and bound its error at once. Sums and products may be fused, and
// reordered between operands of one formula, for every step contains the unrounded value. Beside the Interval of
// harness/bounded.h it knows what a hostile mesh makes: NaN, what overflows, and 0 times the unknown.
#pragma once
#include "harness/bounded.h"

namespace assay::deferred_texturing {

constexpr double kUlp = 2 * kUnitRoundoff;  // of a float, relative, at most
constexpr double kTiny = 0x1p-126;          // denormals may be flushed
using bounded::kInfinite;

struct Range {
  double low = 0, high = 0;
  Range() = default;
  constexpr Range(double exact) : low(exact), high(exact) {}  // NOLINT: a number is a range
  constexpr Range(double l, double h) : low(l), high(h) {}
  constexpr Range(Interval i) : low(i.low), high(i.high) {}    // NOLINT: the same without NaN
  constexpr operator Interval() const { return {low, high}; }  // NOLINT: of one that is no NaN
  double middle() const { return low + (high - low) / 2; }
  double radius() const { return (high - low) / 2; }
  bool is_nan() const { return std::isnan(low); }  // surely not a number
};
inline Range unknown() { return {-kInfinite, kInfinite}; }
inline Range hull(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

// After an operation that loses `ulps`; past the largest float anything may follow.
inline Range rounded(Range r, double ulps = 0.5) {
  if (r.is_nan()) return r;
  if (!(std::max(std::fabs(r.low), std::fabs(r.high)) < 3.4e38)) return unknown();
  return {r.low - std::fabs(r.low) * ulps * kUlp - kTiny, r.high + std::fabs(r.high) * ulps * kUlp + kTiny};
}

inline Range operator-(Range a) { return {-a.high, -a.low}; }
inline Range operator+(Range a, Range b) { return rounded({a.low + b.low, a.high + b.high}); }
inline Range operator-(Range a, Range b) { return a + -b; }
inline Range operator*(Range a, Range b) {
  if (a.is_nan() || b.is_nan()) return {NAN, NAN};
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return unknown();  // 0 times the unknown
  return rounded({std::min({p, q, r, s}), std::max({p, q, r, s})});
}
inline Range square(Range a) {
  if (a.is_nan()) return a;
  const double p = a.low * a.low, q = a.high * a.high;
  return rounded({a.low <= 0 && a.high >= 0 ? 0 : std::min(p, q), std::max(p, q)});
}
// By a positive range; 2.5 ulp.
inline Range operator/(Range a, Range b) {
  if (a.is_nan() || b.is_nan()) return {NAN, NAN};
  if (!(b.low > 0)) return unknown();
  const double p = a.low / b.low, q = a.low / b.high, r = a.high / b.low, s = a.high / b.high;
  return rounded({std::min({p, q, r, s}), std::max({p, q, r, s})}, 2.5);
}
// Inherited from 1 / inversesqrt: 2.5 + 2 ulp.
inline Range root(Range a) {
  if (a.is_nan()) return a;
  return rounded({std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0))}, 4.5);
}
// The device may take either end for NaN.
inline Range clamped(Range a, double low, double high) {
  if (a.is_nan()) return {low, high};
  return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)};
}
// a (1 - w) + b w or a + (b - a) w: extremes at the corners; three roundings of terms no larger than |a| + |b|.
inline Range mixed(Range a, Range b, Range w) {
  if (a.is_nan() || b.is_nan() || w.is_nan()) return {NAN, NAN};
  Range all = {kInfinite, -kInfinite};
  for (const double x : {a.low, a.high})
    for (const double y : {b.low, b.high})
      for (const double t : {w.low, w.high}) {
        const double m = x + (y - x) * t;
        if (std::isnan(m)) return unknown();
        all = hull(all, m);
      }
  const double size = std::max(std::fabs(a.low), std::fabs(a.high)) + std::max(std::fabs(b.low), std::fabs(b.high));
  return {all.low - 3 * kUlp * size - kTiny, all.high + 3 * kUlp * size + kTiny};
}

using Range3 = std::array<Range, 3>;
inline Range3 mixed(const Range3& a, const Range3& b, Range w) {
  return {mixed(a[0], b[0], w), mixed(a[1], b[1], w), mixed(a[2], b[2], w)};
}
inline Range3 operator*(const Range3& a, const Range3& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
inline Range3 operator*(Range s, const Range3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Range3 operator+(const Range3& a, const Range3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Range3 operator-(const Range3& a) { return {-a[0], -a[1], -a[2]}; }

}  // namespace assay::deferred_texturing
