// Numbers that a device computed in float, as what they may be: intervals, and vectors within a ball. Every operation
// adds the rounding that Vulkan allows it, so that an oracle written with them is both the formula and its forward
// error bound. In units of u = 2^-24: sums and products 1, division 5 (2.5 ulp), inverse square roots 4 (2 ulp), square
// roots 9 (their reciprocal). An operation fused into another is rounded less, which the interval holds. The doubles'
// own rounding, 2^-53, is covered by kSlack. Host only.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "harness/oracle.h"

namespace assay {

struct Interval {
  double low = 0, high = 0;
};
inline Interval exactly(double v) { return {v, v}; }
inline Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

namespace bounded {

constexpr double u = kUnitRoundoff;
constexpr double kSlack = 1 + 0x1p-20;  // of the errors: second orders, and the doubles'
constexpr double kInfinite = std::numeric_limits<double>::infinity();

inline Interval rounded(Interval i, double units) {
  const double relative = units * u * kSlack;
  return {i.low - std::fabs(i.low) * relative, i.high + std::fabs(i.high) * relative};
}

inline double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }  // 0 also where one is infinite

}  // namespace bounded

inline Interval operator-(Interval a) { return {-a.high, -a.low}; }
inline Interval operator+(Interval a, Interval b) { return bounded::rounded({a.low + b.low, a.high + b.high}, 1); }
inline Interval operator-(Interval a, Interval b) { return a + -b; }
inline Interval operator*(Interval a, Interval b) {
  const auto [low, high] = std::minmax({bounded::product(a.low, b.low), bounded::product(a.low, b.high),
                                        bounded::product(a.high, b.low), bounded::product(a.high, b.high)});
  return bounded::rounded({low, high}, 1);
}
// Of a divisor that is not negative.
inline Interval operator/(Interval a, Interval b) {
  const double low = std::max(b.low, 0.0), high = std::max(b.high, 0.0);
  const auto over = [](double x, double y) { return x == 0 ? 0 : x / y; };
  return bounded::rounded({over(a.low, a.low < 0 ? low : high), over(a.high, a.high < 0 ? high : low)}, 5);
}
inline Interval square(Interval a) {
  const double most = std::max(std::fabs(a.low), std::fabs(a.high));
  const double least = a.low <= 0 && a.high >= 0 ? 0 : std::min(std::fabs(a.low), std::fabs(a.high));
  return bounded::rounded({least * least, most * most}, 1);
}
inline Interval square_root(Interval a) {
  return bounded::rounded({std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0))}, 9);
}
inline Interval at_least(Interval a, double v) { return {std::max(a.low, v), std::max(a.high, v)}; }
inline Interval at_most(Interval a, double v) { return {std::min(a.low, v), std::min(a.high, v)}; }
inline Interval clamped(Interval a, double low, double high) { return at_most(at_least(a, low), high); }

inline Interval absolute(Interval a) {
  const double low = std::fabs(a.low), high = std::fabs(a.high);
  return {a.low <= 0 && a.high >= 0 ? 0 : std::min(low, high), std::max(low, high)};
}
// a (1 - t) + b t or a + (b - a) t: extremes at the corners, three roundings of terms no larger than |a| + |b|.
inline Interval mixed(Interval a, Interval b, Interval t) {
  Interval all = {bounded::kInfinite, -bounded::kInfinite};
  for (const double x : {a.low, a.high})
    for (const double y : {b.low, b.high})
      for (const double w : {t.low, t.high}) all = hull(all, exactly(x + (y - x) * w));
  const double error = 3 * bounded::u * bounded::kSlack * (absolute(a).high + absolute(b).high);
  return {all.low - error, all.high + error};
}
// A number of terms summed in any order, fused or not.
inline Interval sum_of(std::initializer_list<Interval> terms) {
  Interval sum;
  double size = 0;
  for (const Interval t : terms) sum.low += t.low, sum.high += t.high, size += absolute(t).high;
  const double error = static_cast<double>(terms.size()) * bounded::u * bounded::kSlack * size;
  return {sum.low - error, sum.high + error};
}

using Intervals3 = std::array<Interval, 3>;  // of a colour's channels
inline Intervals3 operator+(const Intervals3& a, const Intervals3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Intervals3 operator*(const Intervals3& a, const Intervals3& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
inline Intervals3 operator*(const Intervals3& a, Interval b) { return {a[0] * b, a[1] * b, a[2] * b}; }

// A vector that lies no farther than `error` from `value`.
struct Ball {
  glm::dvec3 value = {};
  double error = 0;
};

inline double reach(const Ball& a) { return glm::length(a.value) + a.error; }  // its greatest length
inline Ball operator-(const Ball& a) { return {-a.value, a.error}; }
inline Ball operator+(const Ball& a, const Ball& b) {
  const glm::dvec3 sum = a.value + b.value;
  const double error = a.error + b.error;
  return {sum, (error + bounded::u * (glm::length(sum) + error)) * bounded::kSlack};
}
inline Ball operator-(const Ball& a, const Ball& b) { return a + -b; }

// Three products, two sums in any order: 3u of the terms' magnitudes.
inline Interval dot(const Ball& a, const Ball& b) {
  const double at = glm::dot(a.value, b.value), terms = glm::dot(glm::abs(a.value), glm::abs(b.value));
  const double moved = a.error * glm::length(b.value) + b.error * glm::length(a.value) + a.error * b.error;
  const double error = (moved + 3 * bounded::u * (terms + moved)) * bounded::kSlack;
  return {at - error, at + error};
}
inline Interval length_squared(const Ball& a) {
  const double length = glm::length(a.value), least = std::max(length - a.error, 0.0), most = length + a.error;
  return bounded::rounded({least * least, most * most}, 3);
}
// A component is a difference of two products, 2u of their magnitudes.
inline Ball cross(const Ball& a, const Ball& b) {
  const glm::dvec3 p = glm::abs(a.value), q = glm::abs(b.value);
  const glm::dvec3 terms = {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
  const double moved = a.error * glm::length(b.value) + b.error * glm::length(a.value) + a.error * b.error;
  return {glm::cross(a.value, b.value),
          (moved * (1 + 4 * bounded::u) + 2 * bounded::u * glm::length(terms)) * bounded::kSlack};
}
// v * inversesqrt(max(dot(v, v), shortest^2)). The direction turns by error / length at most; the length is off by half
// of the square's 3u, the root's 4u and the product's u, 6.5u. A vector that may be shorter than `shortest` may come
// out as any of length 1 or less.
inline Ball normalised(const Ball& a, double shortest) {
  const double length = glm::length(a.value), rounding = 6.5 * bounded::u;
  if (length - a.error < shortest * (1 + 1e-5))
    return {length > 0 ? a.value / length : glm::dvec3(0), 2 + 2 * rounding};
  return {a.value / length, (a.error / (length - a.error) + rounding) * bounded::kSlack};
}

}  // namespace assay
