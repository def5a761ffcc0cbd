// Exact values beside a bound of what float arithmetic may make of them: running error analysis (Higham 2002, chapter
// 3).
#pragma once
#include <algorithm>
#include <cmath>

#include "harness/oracle.h"

namespace assay::interpolation {

using Wide = __float128;

// A few of a thing, indexed by int as GLM's vectors are.
template <class T, int n>
struct Few {
  T of[n];
  constexpr T& operator[](int i) { return of[i]; }
  constexpr const T& operator[](int i) const { return of[i]; }
  const T* begin() const { return of; }
  const T* end() const { return of + n; }
  T* begin() { return of; }
  T* end() { return of + n; }
};

// A number that a shader works out: its exact value, in a type that is wide enough to hold it, and how far from it a
// device may be. Each operation rounds once by at most u of its result; Wide adds 2^-112 of it, double 2^-52, which `u`
// below is enlarged by. Results under 2^-126 may be flushed to zero.
template <class T>
struct Rounded {
  T value = 0;
  double error = 0;
};
using RoundedWide = Rounded<Wide>;
using RoundedDouble = Rounded<double>;

constexpr double u = kUnitRoundoff + 0x1p-50;
constexpr double kFlushed = 0x1p-126;

template <class T>
double magnitude(const T& v) {
  return static_cast<double>(v < 0 ? -v : v);
}
// The largest magnitude that the device may hold.
template <class T>
double reach(const Rounded<T>& a) {
  return magnitude(a.value) * (1 + 0x1p-50) + a.error;
}
template <class T>
bool is_zero(const Rounded<T>& a) {
  return a.value == 0 && a.error == 0;
}
template <class T>
Rounded<T> rounded(T value, double error) {
  return {value, error + u * (magnitude(value) + error) + kFlushed};
}

template <class T>
double product_error(const Rounded<T>& a, const Rounded<T>& b) {
  return magnitude(a.value) * b.error + magnitude(b.value) * a.error + a.error * b.error;
}
template <class T>
Rounded<T> operator*(const Rounded<T>& a, const Rounded<T>& b) {
  if (is_zero(a) || is_zero(b)) return {};
  return rounded<T>(a.value * b.value, product_error(a, b));
}
template <class T>
Rounded<T> operator+(const Rounded<T>& a, const Rounded<T>& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return rounded<T>(a.value + b.value, a.error + b.error);
}
template <class T>
Rounded<T> operator-(const Rounded<T>& a) {
  return {-a.value, a.error};
}
template <class T>
Rounded<T> operator-(const Rounded<T>& a, const Rounded<T>& b) {
  return a + -b;
}
template <class T>
Rounded<T> not_negative(const Rounded<T>& a) {
  return {a.value < 0 ? T(0) : a.value, a.error};
}
// 1 / a, by Vulkan's 2.5 ulp of a division; `a` must be farther from 0 than its error.
template <class T>
Rounded<T> reciprocal(const Rounded<T>& a) {
  const double nearest = magnitude(a.value) - a.error;
  const double moved = a.error / (magnitude(a.value) * nearest);
  return {1 / a.value, moved + 5 * u / nearest};
}

// a * b - c * d with little of it lost to cancellation (products.glsl): twice u of the result. Split products add the
// rounding of the difference of two product errors, u * 2u of the larger product.
template <class T>
Rounded<T> difference_of_products(const Rounded<T>& a, const Rounded<T>& b, const Rounded<T>& c, const Rounded<T>& d) {
  const T value = a.value * b.value - c.value * d.value;
  const double error = product_error(a, b) + product_error(c, d);
  const double larger = std::max(reach(a) * reach(b), reach(c) * reach(d));
  if (larger == 0) return {};
  return {value, error + 2 * u * (magnitude(value) + error) + 4 * u * u * larger + 4 * kFlushed};
}

inline RoundedDouble narrowed(const RoundedWide& a) {
  const auto v = static_cast<double>(a.value);
  return {v, a.error + 0x1p-53 * std::fabs(v)};
}

}  // namespace assay::interpolation
