#include "kernels/visibility/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assay::visibility {

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kGuard = 32768;  // pixels; no guard band of a device reaches further

struct Polygon {
  std::array<Corner, 4> corners = {};
  // The triangle's edge from a corner to the next: its two vertices; from == to on the near cut.
  std::array<std::pair<uint32_t, uint32_t>, 4> edges = {};
  std::array<bool, 4> on_near = {};
  uint32_t count = 0;
};

// The triangle in front of the near plane (Sutherland, Hodgman 1974, one plane).
Polygon clip_near(const std::array<ClipVertex, 3>& v, const Target& t) {
  Polygon p;
  const auto add = [&p](const Corner& c, uint32_t from, uint32_t to, bool on_near) {
    p.corners[p.count] = c;
    p.on_near[p.count] = on_near;
    p.edges[p.count++] = {from, to};
  };
  for (uint32_t i = 0; i < 3; ++i) {
    const uint32_t j = (i + 1) % 3;
    const bool inside = v[i].w >= t.near_plane, next_inside = v[j].w >= t.near_plane;
    if (inside) add(corner_of(v[i], t), i, j, false);
    if (inside && !next_inside) add(near_corner(v[i], v[j], t), i, i, true);
    if (!inside && next_inside) add(near_corner(v[j], v[i], t), i, j, true);
  }
  return p;
}

bool inside_viewport(const Corner& c, const Target& t) {
  return c.snapped_x - c.snap_x >= 0 && c.snapped_y - c.snap_y >= 0 && c.snapped_x + c.snap_x <= t.width &&
         c.snapped_y + c.snap_y <= t.height;
}

// The part of a-b inside a box, as fractions; empty where first > last.
struct Span {
  double first = 0, last = 1;
};
Span span_in(const Corner& a, const Corner& b, double x_low, double y_low, double x_high, double y_high) {
  Span s;
  const auto cut = [&s](double from, double to, double low, double high) {
    const double d = to - from;
    if (d == 0) {
      if (from < low || from > high) s.last = -1;
      return;
    }
    const double p = (low - from) / d, q = (high - from) / d;
    s.first = std::max(s.first, std::min(p, q));
    s.last = std::min(s.last, std::max(p, q));
  };
  cut(a.x, b.x, x_low, x_high);
  cut(a.y, b.y, y_low, y_high);
  return s;
}

struct Point {
  double x, y;
};

// The polygon inside a box, for its size alone.
std::vector<Point> clip_box(std::vector<Point> p, double x_low, double y_low, double x_high, double y_high) {
  const auto clip = [&p](auto distance) {
    std::vector<Point> out;
    for (size_t i = 0; i < p.size(); ++i) {
      const Point &a = p[i], &b = p[(i + 1) % p.size()];
      const double da = distance(a), db = distance(b);
      if (da >= 0) out.push_back(a);
      if ((da < 0) != (db < 0)) out.push_back({a.x + da / (da - db) * (b.x - a.x), a.y + da / (da - db) * (b.y - a.y)});
    }
    p = std::move(out);
  };
  clip([=](const Point& a) { return a.x - x_low; });
  clip([=](const Point& a) { return x_high - a.x; });
  clip([=](const Point& a) { return a.y - y_low; });
  clip([=](const Point& a) { return y_high - a.y; });
  return p;
}

// Adds what a plane through this polygon's corners may be off, in units of u: README, "Interpolation".
void widen_rounding(Shape& s, const std::vector<Point>& p) {
  if (p.size() < 3) return;
  double x_low = p[0].x, x_high = p[0].x, y_low = p[0].y, y_high = p[0].y, area2 = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    x_low = std::min(x_low, a.x), x_high = std::max(x_high, a.x);
    y_low = std::min(y_low, a.y), y_high = std::max(y_high, a.y);
    area2 += (a.x - p[0].x) * (b.y - p[0].y) - (a.y - p[0].y) * (b.x - p[0].x);
  }
  const double width = x_high - x_low, height = y_high - y_low, fullness = width * height / (0.5 * std::fabs(area2));
  s.rounding.x = std::max(s.rounding.x, 12 * fullness * width + 4 * std::max(std::fabs(x_low), std::fabs(x_high)));
  s.rounding.y = std::max(s.rounding.y, 12 * fullness * height + 4 * std::max(std::fabs(y_low), std::fabs(y_high)));
  if (!(fullness < 0x1p16)) s.planes_known = false;  // an area that is all cancellation
}

// Twice the area, and a bound of what moved corners do to it.
struct Area {
  double twice, error;
};
Area area_of(const Polygon& p, const std::array<double, 4>& moved) {
  Area a = {0, 0};
  const Corner& o = p.corners[0];
  for (uint32_t i = 0; i < p.count; ++i) {
    const uint32_t next = (i + 1) % p.count, last = (i + p.count - 1) % p.count;
    const Corner &b = p.corners[i], &c = p.corners[next], &d = p.corners[last];
    a.twice += (b.snapped_x - o.snapped_x) * (c.snapped_y - o.snapped_y) -
               (b.snapped_y - o.snapped_y) * (c.snapped_x - o.snapped_x);
    a.error += moved[i] * (std::fabs(c.snapped_x - d.snapped_x) + std::fabs(c.snapped_y - d.snapped_y)) +
               2 * moved[i] * moved[next];
  }
  return a;
}

// How far the ends of edge i may be from the snapped corners, where the device may cut it at a side of the screen.
struct Ends {
  double a = 0, b = 0, relative = 0;
};
Ends ends_of(const Polygon& p, uint32_t i, const std::array<ClipVertex, 3>& v, const Target& t) {
  const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
  Ends e = {std::max(a.snap_x, a.snap_y), std::max(b.snap_x, b.snap_y), 0};
  if (inside_viewport(a, t) && inside_viewport(b, t)) return e;
  const Span s = span_in(a, b, 0, 0, t.width, t.height);
  const auto [from, to] = p.edges[i];
  double inverse_w = 0;
  if (s.first <= s.last) {
    const auto at = [&](double f) { return a.inverse_w + f * (b.inverse_w - a.inverse_w); };
    inverse_w = std::max(at(s.first), at(s.last));
  }
  const SideError side = side_error(v[from], v[to], inverse_w, t);
  return {std::max({e.a, a.moved, side.moved}), std::max({e.b, b.moved, side.moved}), side.relative};
}

void set_planes(Shape& s, const std::array<ClipVertex, 3>& v, const Target& t) {
  // Centred on the shape, so that no precision is lost to the distance from the screen's corner.
  s.origin_x = 0.5 * (s.x_first + s.x_end), s.origin_y = 0.5 * (s.y_first + s.y_end);
  std::array<double, 3> x = {}, y = {};
  for (uint32_t k = 0; k < 3; ++k) {
    x[k] = 0.5 * t.width * v[k].x + (0.5 * t.width - s.origin_x) * v[k].w;
    y[k] = 0.5 * t.height * v[k].y + (0.5 * t.height - s.origin_y) * v[k].w;
  }
  const auto cofactor = [&](uint32_t i, uint32_t j) {
    return Plane{x[i] * y[j] - y[i] * x[j], y[i] * v[j].w - v[i].w * y[j], v[i].w * x[j] - x[i] * v[j].w};
  };
  s.weights = {cofactor(1, 2), cofactor(2, 0), cofactor(0, 1)};
  const double determinant =
      v[0].w * s.weights[0].at_origin + v[1].w * s.weights[1].at_origin + v[2].w * s.weights[2].at_origin;
  if (!(std::fabs(determinant) > 1e-300)) s.planes_known = false;
  for (Plane& w : s.weights) {
    w.at_origin /= determinant, w.d_dx /= determinant, w.d_dy /= determinant;
    s.inverse_w.at_origin += w.at_origin, s.inverse_w.d_dx += w.d_dx, s.inverse_w.d_dy += w.d_dy;
  }
  // Parallel to the screen: exactly so, since differences of equal numbers are zero in any arithmetic.
  if (v[0].w == v[1].w && v[1].w == v[2].w) s.inverse_w = {1 / v[0].w, 0, 0};
}

void set_errors(Shape& s, const Polygon& p, const Target& t, double twice_area) {
  std::vector<Point> outline;
  double longest = 0;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    outline.push_back({a.x, a.y});
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    double& moved = p.on_near[i] ? s.near_moved : s.moved;
    moved = std::max(moved, a.moved);
    s.relative_error = std::max(s.relative_error, a.relative_error);
  }
  s.height = std::fabs(twice_area) / longest - 2 * s.moved;
  if (!(s.height > 2 * s.moved)) s.planes_known = false;
  s.stretch = stretch_at(s, 0);
  s.rounding = {4 * t.width, 4 * t.height};
  widen_rounding(s, clip_box(outline, -kGuard, -kGuard, kGuard, kGuard));
  widen_rounding(s, clip_box(outline, 0, 0, t.width, t.height));
}

void set_bounds(Shape& s, const Polygon& p, const Target& t) {
  double x_low = 1e30, y_low = 1e30, x_high = -1e30, y_high = -1e30;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner& c = p.corners[i];
    x_low = std::min(x_low, c.x - c.moved), x_high = std::max(x_high, c.x + c.moved);
    y_low = std::min(y_low, c.y - c.moved), y_high = std::max(y_high, c.y + c.moved);
  }
  const auto pixel = [](double v, double size) { return static_cast<uint32_t>(std::clamp(v, 0.0, size)); };
  s.x_first = pixel(std::ceil(x_low - 0.5), t.width), s.x_end = pixel(std::floor(x_high + 0.5), t.width);
  s.y_first = pixel(std::ceil(y_low - 0.5), t.height), s.y_end = pixel(std::floor(y_high + 0.5), t.height);
}

Edge edge_of(const Polygon& p, uint32_t i, const Ends& ends, bool clockwise) {
  const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
  Edge e = {a.snapped_x, a.snapped_y, b.snapped_x, b.snapped_y, ends.a, ends.b, p.edges[i].first, p.edges[i].second};
  if (!clockwise) {
    std::swap(e.ax, e.bx), std::swap(e.ay, e.by), std::swap(e.a_moved, e.b_moved);
    std::swap(e.from, e.to);
  }
  const double dx = e.bx - e.ax, dy = e.by - e.ay;
  // With y down and the interior on the positive side: up is a left edge, rightwards a top edge.
  e.inclusive = dy < 0 || (dy == 0 && dx > 0);
  return e;
}

}  // namespace

Shape shape_of(const std::array<ClipVertex, 3>& v, Facing facing, const Target& t) {
  Shape s;
  s.near_plane = t.near_plane;
  const Polygon p = clip_near(v, t);
  if (p.count == 0) return s;
  double w_error = 0, w_sum = 0;
  for (const ClipVertex& c : v) {
    s.crosses_near |= c.w - c.w_error < t.near_plane;
    w_error = std::max(w_error, c.w_error);
    w_sum += std::fabs(c.w);
  }
  if (s.crosses_near) s.near_slack = (4 * u * w_sum + 2 * w_error) / t.near_plane;
  set_bounds(s, p, t);
  if (s.x_first >= s.x_end || s.y_first >= s.y_end) return s;

  std::array<Ends, 4> ends = {};
  std::array<double, 4> moved = {};
  for (uint32_t i = 0; i < p.count; ++i) {
    ends[i] = ends_of(p, i, v, t);
    moved[i] = std::max(moved[i], ends[i].a);
    moved[(i + 1) % p.count] = std::max(moved[(i + 1) % p.count], ends[i].b);
    s.relative_error = std::max(s.relative_error, ends[i].relative);
  }
  const Area area = area_of(p, moved);
  const double doubt = area.error + 0x1p-48 * std::fabs(area.twice);
  if (area.error == 0 && area.twice == 0) return s;
  s.certain = std::fabs(area.twice) > doubt;
  set_planes(s, v, t);
  set_errors(s, p, t, area.twice);
  for (const bool clockwise : {true, false}) {
    if (s.certain && (area.twice > 0) != clockwise) continue;
    // Clockwise in framebuffer coordinates is the back of a surface that was not mirrored.
    if (facing == (clockwise ? Facing::cull_back : Facing::cull_front)) continue;
    for (uint32_t i = 0; i < p.count; ++i)
      if (p.edges[i].first != p.edges[i].second) s.edges.push_back(edge_of(p, i, ends[i], clockwise));
  }
  s.whole = !s.crosses_near;
  for (uint32_t i = 0; i < p.count; ++i) s.whole = s.whole && inside_viewport(p.corners[i], t);
  s.edges_a_side = 0;
  for (uint32_t i = 0; i < p.count; ++i) s.edges_a_side += p.edges[i].first != p.edges[i].second;
  return s;
}

namespace {

Cover side_of(const Edge& e, double x, double y) {
  const double p = (e.bx - e.ax) * (y - e.ay), q = (e.by - e.ay) * (x - e.ax), value = p - q;
  if (e.a_moved == 0 && e.b_moved == 0)  // all on the grid: exact in double
    return value > 0 || (value == 0 && e.inclusive) ? Cover::in : Cover::out;
  // cross(b' - a', p - a') with each end moved: first order in each, and their product.
  const double error = e.b_moved * (std::fabs(x - e.ax) + std::fabs(y - e.ay)) +
                       e.a_moved * (std::fabs(e.bx - x) + std::fabs(e.by - y)) + 2 * e.a_moved * e.b_moved +
                       0x1p-50 * (std::fabs(p) + std::fabs(q));
  return value > error ? Cover::in : value < -error ? Cover::out : Cover::maybe;
}

}  // namespace

Coverage covers(const Shape& s, double x, double y) {
  Coverage best;
  for (uint32_t first = 0; first < s.edges.size(); first += s.edges_a_side) {
    Coverage here = {s.certain ? Cover::in : Cover::maybe, kNoEdge};
    uint32_t doubts = s.certain ? 0 : 2;
    for (uint32_t i = first; i < first + s.edges_a_side && here.cover != Cover::out; ++i) {
      const Cover side = side_of(s.edges[i], x, y);
      here.cover = std::min(here.cover, side);
      if (side == Cover::maybe) here.only_doubt = doubts++ == 0 ? i : kNoEdge;
    }
    if (here.cover > best.cover) best = here;
  }
  return best;
}

Plane depth_plane(const Shape& s) {
  return {s.inverse_w.at_origin * s.near_plane, s.inverse_w.d_dx * s.near_plane, s.inverse_w.d_dy * s.near_plane};
}

double evaluate(const Shape& s, const Plane& p, double x, double y) {
  return p.at_origin + p.d_dx * (x - s.origin_x) + p.d_dy * (y - s.origin_y);
}

double stretch_at(const Shape& s, double outside) {
  // Covered pixels lie within the corners as they were moved for coverage, at most twice that beside those of the
  // planes: two weights down to -distance / height, and the third makes up for them.
  return 1 + 4 * (outside + 2 * s.moved) / s.height;
}

double rounding_of(const Shape& s, const Plane& p, double value) {
  if (p.d_dx == 0 && p.d_dy == 0) return 0;
  return u * (s.rounding.x * std::fabs(p.d_dx) + s.rounding.y * std::fabs(p.d_dy) + 4 * std::fabs(value));
}

double moved_at(const Shape& s, double depth) { return s.moved + std::min(std::fabs(depth), 1.0) * s.near_moved; }

namespace {

double depth_error(const Shape& s, const Plane& p, double depth) {
  const double slope = std::fabs(p.d_dx) + std::fabs(p.d_dy);
  return s.stretch * (slope * moved_at(s, depth) + std::fabs(depth) * s.relative_error) + rounding_of(s, p, depth);
}

}  // namespace

Cover before_near(const Shape& s, double x, double y) {
  if (!s.crosses_near) return Cover::in;
  if (!s.planes_known) return Cover::maybe;
  const Plane p = depth_plane(s);
  const double depth = evaluate(s, p, x, y);
  const double error = depth_error(s, p, depth) + s.near_slack;
  return depth < 1 - error ? Cover::in : depth > 1 + error ? Cover::out : Cover::maybe;
}

Interval depth_at(const Shape& s, double x, double y) {
  if (!s.planes_known) return {0, std::numeric_limits<double>::infinity()};
  const Plane p = depth_plane(s);
  const double depth = evaluate(s, p, x, y);
  const double error = depth_error(s, p, depth);
  return {std::max(depth - error, 0.0), std::max(depth + error, 0.0)};
}

}  // namespace assay::visibility
