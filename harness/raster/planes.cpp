// What a shape's planes say at a pixel, and how far a device may be from that.
#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/raster/coverage.h"

namespace assay::raster {

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

float float_at_most(double v) {
  const auto f = static_cast<float>(v);
  return double{f} > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float float_at_least(double v) { return -float_at_most(-v); }

double evaluate(const Shape& s, const Plane& p, double x, double y) {
  return p.at_origin + p.d_dx * (x - s.origin_x) + p.d_dy * (y - s.origin_y);
}

namespace {

// Inside, or so near that the rasteriser's grid may move it in.
bool holds(const Piece& p, double x, double y) {
  constexpr double kBeside = 2.0 / 256;  // pixels: snapped twice, the coverage's corners and the planes'
  std::array<double, 3> sides;
  double turn = 0;
  for (uint32_t i = 0; i < 3; ++i) {
    const Point &a = p.corners[i], &b = p.corners[(i + 1) % 3];
    const double length = std::hypot(b.x - a.x, b.y - a.y), side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    sides[i] = length > 0 ? side / length : 0;
    turn += a.x * b.y - a.y * b.x;
  }
  return std::ranges::all_of(sides, [&](double d) { return (turn < 0 ? -d : d) >= -kBeside; });
}

}  // namespace

double stretch_at(const Shape& s, double outside, double x, double y) {
  // Covered pixels lie within the corners as they were moved for coverage, at most twice that beside those of the
  // planes: two weights down to -distance / height, and the third makes up for them.
  const auto of = [outside](double moved, double height) { return 1 + 4 * (outside + 2 * moved) / height; };
  double most = of(s.moved, s.height);
  for (const Piece& p : s.pieces)
    if (holds(p, x, y)) most = std::max(most, p.known ? of(p.moved, p.height) : kUnknown);
  return most;
}

double rounding_of(const Shape& s, const Plane& p, double value, double x, double y) {
  if (p.d_dx == 0 && p.d_dy == 0) return 0;
  const auto of = [&](const Rounding& r) { return u * (r.x * std::fabs(p.d_dx) + r.y * std::fabs(p.d_dy)); };
  double most = of(s.rounding);
  for (const Piece& piece : s.pieces)
    if (holds(piece, x, y)) most = std::max(most, piece.known ? of(piece.rounding) : kUnknown);
  return most + 4 * u * std::fabs(value);
}

double moved_at(const Shape& s, double depth) { return s.moved + std::min(std::fabs(depth), 1.0) * s.near_moved; }

namespace {

double depth_error(const Shape& s, double depth, double x, double y) {
  const double slope = std::fabs(s.depth.d_dx) + std::fabs(s.depth.d_dy);
  const double corners = slope * moved_at(s, depth) + std::fabs(depth) * s.relative_error + s.z_error;
  return (corners == 0 ? 0 : stretch_at(s, 0, x, y) * corners) + rounding_of(s, s.depth, depth, x, y);
}

}  // namespace

Cover in_depth(const Shape& s, double x, double y) {
  if (!s.crosses_near && !s.crosses_far) return Cover::in;
  if (!s.planes_known) return Cover::maybe;
  const double depth = evaluate(s, s.depth, x, y), error = depth_error(s, depth, x, y) + s.cut_slack;
  const auto before = [error](double distance) {
    return distance > error ? Cover::in : distance < -error ? Cover::out : Cover::maybe;
  };
  return std::min(s.crosses_near ? before(1 - depth) : Cover::in, s.crosses_far ? before(depth) : Cover::in);
}

Interval depth_at(const Shape& s, double x, double y) {
  if (!s.planes_known) return {0, kUnknown};
  const double depth = evaluate(s, s.depth, x, y), error = depth_error(s, depth, x, y);
  return {std::max(depth - error, 0.0), std::max(depth + error, 0.0)};
}

}  // namespace assay::raster
