#include "harness/raster/clip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace assay::raster {

namespace {

constexpr double u = kUnitRoundoff;
// Snapping to the grid. Vulkan names the grid (subPixelPrecisionBits), not the rounding; Direct3D 11 lets the
// conversion to fixed point be off by 0.6 of a step where exact rounding is off by 0.5.
constexpr double kSnapSteps = 0.6;
// A division is good to 2.5 ulp in Vulkan's table for shaders; the fixed-function one is taken to be no worse.
constexpr double kDivision = 5 * u;
constexpr double kSmallest = 0x1p-126;
constexpr double kAnywhere = 1e9;  // pixels: a position of which nothing is known

// The value of the lowest set bit.
double lowest_bit(double v) {
  int exponent;
  const double mantissa = std::frexp(std::fabs(v), &exponent);
  const auto bits = static_cast<uint64_t>(std::ldexp(mantissa, 53));
  return std::ldexp(1.0, exponent - 53 + std::countr_zero(bits));
}

struct Dot {
  double value, error;
};

// dot(row, vec4(p, 1)) in fp32, summed in any order, fused or not: each term meets four roundings at most. Where all
// terms are multiples of one power of two and their magnitudes sum to below 2^24 of it, every order is exact.
Dot dot_bound(const vec4& row, const vec3& p) {
  const std::array<double, 4> terms = {double{row.x} * p.x, double{row.y} * p.y, double{row.z} * p.z, double{row.w}};
  double value = 0, magnitude = 0, step = 0x1p200;
  for (const double t : terms) {
    value += t;
    magnitude += std::fabs(t);
    if (t != 0) step = std::min(step, lowest_bit(t));
  }
  const bool exact = magnitude == 0 || (magnitude < 0x1p24 * step && step >= kSmallest);
  return {value, exact ? 0 : 4.01 * u * magnitude + 4 * kSmallest};
}

bool is_float(double v) { return double{static_cast<float>(v)} == v; }
bool is_power_of_two(double v) {
  int e;
  return std::frexp(v, &e) == 0.5;
}

struct Coordinate {
  double value, error;
};

// clip / w on to pixels: ndc * half + half, in whichever order.
Coordinate to_pixels(double clip, double clip_error, const ClipVertex& v, double half) {
  const double ndc = clip / v.w, scaled = ndc * half, value = scaled + half;
  const bool known = clip_error == 0 && v.w_error == 0 && is_power_of_two(v.w);
  if (known && is_float(ndc) && is_float(scaled) && is_float(value) && is_float(ndc * 0.5 + 0.5) &&
      is_float(value - 0.5))
    return {value, 0};
  if (!(v.w > 2 * v.w_error)) return {value, kAnywhere};
  const double carried = (clip_error + std::fabs(ndc) * v.w_error) / (v.w - v.w_error) * half;
  // Division, product, sum, and one more where an implementation moves to pixel centres.
  const double rounding = std::fabs(scaled) * (kDivision + u) + 2 * u * (std::fabs(value) + 1);
  return {value, 1.01 * (carried + rounding)};
}

struct Snapped {
  double centre, half_width;
};

// Grid points within kSnapSteps of where the position may be.
Snapped snap(Coordinate c, double grid) {
  const double at = c.value * grid, reach = c.error * grid + kSnapSteps;
  double low = std::ceil(at - reach), high = std::floor(at + reach);
  if (!(low <= high)) low = high = std::nearbyint(at);  // reach is over half a step, so one is always in it
  return {0.5 * (low + high) / grid, 0.5 * (high - low) / grid};
}

Corner corner_at(Coordinate x, Coordinate y, double inverse_w, double relative_error, const Target& t) {
  const Snapped sx = snap(x, t.grid), sy = snap(y, t.grid);
  const double moved = std::max(x.error, y.error) + kSnapSteps / t.grid;
  return {x.value, y.value, inverse_w, sx.centre, sy.centre, sx.half_width, sy.half_width, moved, relative_error};
}

}  // namespace

ClipVertex transform(const Rows& rows, const vec3& p) {
  const Dot x = dot_bound(rows.x, p), y = dot_bound(rows.y, p), z = dot_bound(rows.z, p), w = dot_bound(rows.w, p);
  const auto known = [](const Dot& d) { return std::fabs(d.value) < 0x1p127 && d.error < 0x1p100; };
  return {x.value, y.value, z.value,
          w.value, x.error, y.error,
          z.error, w.error, known(x) && known(y) && known(z) && known(w)};
}

Corner corner_of(const ClipVertex& v, const Target& t) {
  const Coordinate x = to_pixels(v.x, v.x_error, v, 0.5 * t.width), y = to_pixels(v.y, v.y_error, v, 0.5 * t.height);
  const bool exact_w = v.w_error == 0 && is_power_of_two(v.w);
  const double least_w = std::max(v.w - v.w_error, 0.5 * v.w);
  Corner c = corner_at(x, y, 1 / v.w, exact_w ? 0 : v.w_error / least_w + kDivision, t);
  c.z_error = v.z_error / least_w;
  return c;
}

ClipVertex cut_vertex(const ClipVertex& inside, double distance, const ClipVertex& outside, double other) {
  const double along = distance / (distance - other);
  // The error of `along` slides the corner on its edge, which moves the cut (coverage.cpp allows for that) and not the
  // edge; what leaves the edge is the rounding of the interpolation, three operations a coordinate.
  const auto mix = [along](double a, double b) { return a + along * (b - a); };
  const auto error = [](double a, double b, double a_error, double b_error) {
    return 3 * u * (std::fabs(a) + std::fabs(b)) + std::max(a_error, b_error);
  };
  return {mix(inside.x, outside.x),
          mix(inside.y, outside.y),
          mix(inside.z, outside.z),
          mix(inside.w, outside.w),
          error(inside.x, outside.x, inside.x_error, outside.x_error),
          error(inside.y, outside.y, inside.y_error, outside.y_error),
          error(inside.z, outside.z, inside.z_error, outside.z_error),
          error(inside.w, outside.w, inside.w_error, outside.w_error)};
}

SideError side_error(const ClipVertex& a, const ClipVertex& b, double inverse_w, const Target& t) {
  const double w_error = 3 * u * (std::fabs(a.w) + std::fabs(b.w)) + std::max(a.w_error, b.w_error);
  const double x_error = 3 * u * (std::fabs(a.x) + std::fabs(b.x)) + std::max(a.x_error, b.x_error);
  const double y_error = 3 * u * (std::fabs(a.y) + std::fabs(b.y)) + std::max(a.y_error, b.y_error);
  const double z_error = 3 * u * (std::fabs(a.z) + std::fabs(b.z)) + std::max(a.z_error, b.z_error);
  const double x_moved = 0.5 * t.width * (inverse_w * (x_error + w_error) + kDivision + 5 * u);
  const double y_moved = 0.5 * t.height * (inverse_w * (y_error + w_error) + kDivision + 5 * u);
  return {std::max(x_moved, y_moved) + kSnapSteps / t.grid, inverse_w * w_error + kDivision, inverse_w * z_error};
}

double side_moved(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, double inverse_w, const Target& t) {
  // The distances from the side are sums of x or y and w, 2u of them and twice the errors carried; the fraction of the
  // cut is a quotient of them, 4u; then the interpolation's 3u, once more where the near plane cut before.
  double sum = 0, error = 0;
  for (const ClipVertex* v : {&a, &b, &c}) {
    sum += std::max(std::fabs(v->x), std::fabs(v->y)) + 2 * std::fabs(v->w);
    error = std::max({error, v->x_error, v->y_error, v->w_error});
  }
  return 0.5 * std::max(t.width, t.height) * ((12 * u * sum + 8 * error) * inverse_w + kDivision + 5 * u) +
         kSnapSteps / t.grid;
}

}  // namespace assay::raster
