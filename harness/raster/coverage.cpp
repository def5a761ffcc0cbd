#include "harness/raster/coverage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace assay::raster {

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kGuard = 32768;  // pixels; no guard band of a device reaches further

// Where a vertex of the visible polygon is, and the triangle's edge that leaves it: its two vertices; from == to on a
// cut.
struct PolygonVertex {
  ClipVertex at;
  std::pair<uint32_t, uint32_t> edge;
  bool on_near = false;
  bool is_cut = false;  // by either plane: none of the triangle's own
};
struct Polygon {
  std::array<PolygonVertex, 5> vertices = {};
  std::array<Corner, 5> corners = {};
  uint32_t count = 0;
};

double before_near(const ClipVertex& v) { return v.w - v.z; }
double before_far(const ClipVertex& v) { return v.z; }

// Sutherland, Hodgman 1974, one plane.
Polygon clip(const Polygon& p, double (*distance)(const ClipVertex&), bool near) {
  Polygon out;
  for (uint32_t i = 0; i < p.count; ++i) {
    const PolygonVertex &a = p.vertices[i], &b = p.vertices[(i + 1) % p.count];
    const double da = distance(a.at), db = distance(b.at);
    if (da >= 0) out.vertices[out.count++] = a;
    if (da >= 0 && db < 0) out.vertices[out.count++] = {cut_vertex(a.at, da, b.at, db), {0, 0}, near, true};
    if (da < 0 && db >= 0) out.vertices[out.count++] = {cut_vertex(b.at, db, a.at, da), a.edge, near, true};
  }
  return out;
}

// The triangle between the near and the far plane.
Polygon clip_depth(const std::array<ClipVertex, 3>& v, const Target& t) {
  Polygon p;
  for (uint32_t i = 0; i < 3; ++i) p.vertices[p.count++] = {v[i], {i, (i + 1) % 3}};
  p = clip(clip(p, before_near, true), before_far, false);
  for (uint32_t i = 0; i < p.count; ++i) p.corners[i] = corner_of(p.vertices[i].at, t);
  return p;
}

bool inside_target(const Corner& c, const Target& t) {
  return c.snapped_x - c.snap_x >= t.left && c.snapped_y - c.snap_y >= t.top && c.snapped_x + c.snap_x <= t.right &&
         c.snapped_y + c.snap_y <= t.bottom;
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

// What a plane through this polygon's corners may be off: README, "Interpolation".
struct Fullness {
  Rounding rounding;
  double height;  // over the longest side
  bool known;
};
Fullness fullness_of(std::span<const Point> p) {
  double x_low = p[0].x, x_high = p[0].x, y_low = p[0].y, y_high = p[0].y, area2 = 0, longest = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    x_low = std::min(x_low, a.x), x_high = std::max(x_high, a.x);
    y_low = std::min(y_low, a.y), y_high = std::max(y_high, a.y);
    area2 += (a.x - p[0].x) * (b.y - p[0].y) - (a.y - p[0].y) * (b.x - p[0].x);
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  }
  const double width = x_high - x_low, height = y_high - y_low, fullness = width * height / (0.5 * std::fabs(area2));
  return {{12 * fullness * width + 4 * std::max(std::fabs(x_low), std::fabs(x_high)),
           12 * fullness * height + 4 * std::max(std::fabs(y_low), std::fabs(y_high))},
          std::fabs(area2) / longest,
          fullness < 0x1p16};  // else the area is all cancellation
}

void widen_rounding(Shape& s, const std::vector<Point>& p) {
  if (p.size() < 3) return;
  const Fullness f = fullness_of(p);
  s.rounding = {std::max(s.rounding.x, f.rounding.x), std::max(s.rounding.y, f.rounding.y)};
  s.planes_known = s.planes_known && f.known;
}

// Any fan of a polygon is made of triangles between three of its corners.
void add_pieces(Shape& s, const std::vector<Point>& p) {
  const double moved = std::max(s.moved, s.side_moved);
  for (size_t i = 0; i < p.size(); ++i)
    for (size_t j = i + 1; j < p.size(); ++j)
      for (size_t k = j + 1; k < p.size(); ++k) {
        const std::array<Point, 3> corners = {p[i], p[j], p[k]};
        const Fullness f = fullness_of(corners);
        const double height = f.height - 2 * moved;
        s.pieces.push_back({corners, f.rounding, moved, height, f.known && height > 2 * moved});
      }
}

// Twice the area, and a bound of what moved corners do to it.
struct Area {
  double twice, error;
};
Area area_of(const Polygon& p, const std::array<double, 5>& moved) {
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

// How far the ends of edge i may be from the snapped corners, where the device may cut it at a side of the target.
struct Ends {
  double a = 0, b = 0, relative = 0, depth = 0;
};
Ends ends_of(const Polygon& p, uint32_t i, const std::array<ClipVertex, 3>& v, const Target& t) {
  const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
  Ends e = {std::max(a.snap_x, a.snap_y), std::max(b.snap_x, b.snap_y)};
  if (inside_target(a, t) && inside_target(b, t)) return e;
  const Span s = span_in(a, b, t.left, t.top, t.right, t.bottom);
  const auto [from, to] = p.vertices[i].edge;
  double inverse_w = 0;
  if (s.first <= s.last) {
    const auto at = [&](double f) { return a.inverse_w + f * (b.inverse_w - a.inverse_w); };
    inverse_w = std::max(at(s.first), at(s.last));
  }
  const SideError side = side_error(v[from], v[to], inverse_w, t);
  // The cut lies on the line between the moved ends, but for its own rounding.
  return {a.moved + side.moved, b.moved + side.moved, side.relative, side.depth};
}

// A device cuts a triangle into pieces and snaps their corners. One that is snapped past an edge
// turns its piece over, which then covers what lies beyond that edge, up to as far as the corner was moved: the ends of
// edges so near a cut are taken for moved as well.
void widen_near_cuts(const Polygon& p, const Target& t, std::array<Ends, 5>& ends) {
  double cut = 0;  // the most that a corner of a cut and an edge are moved, pixels, in any direction
  std::vector<Point> outline;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    if (!inside_target(a, t) || !inside_target(b, t)) cut = std::max({cut, 1.5 * ends[i].a, 1.5 * ends[i].b});
    if (p.vertices[i].is_cut) cut = std::max(cut, 1.5 * 2 * a.moved);
    outline.push_back({a.x, a.y});
  }
  if (cut == 0) return;
  const std::vector<Point> drawn = clip_box(outline, t.left, t.top, t.right, t.bottom);
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    if (!inside_target(a, t) || !inside_target(b, t)) continue;
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    const bool near = std::ranges::any_of(drawn, [&](const Point& d) {
      const bool is_end = (d.x == a.x && d.y == a.y) || (d.x == b.x && d.y == b.y);
      return !is_end && std::fabs(dx * (d.y - a.y) - dy * (d.x - a.x)) <= 2 * cut * length;
    });
    if (near) ends[i].a = std::max(ends[i].a, cut), ends[i].b = std::max(ends[i].b, cut);
  }
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
  for (uint32_t k = 0; k < 3; ++k) {
    s.depth.at_origin += v[k].z * s.weights[k].at_origin;
    s.depth.d_dx += v[k].z * s.weights[k].d_dx, s.depth.d_dy += v[k].z * s.weights[k].d_dy;
  }
  // Parallel to the screen: exactly so, since differences of equal numbers are zero in any arithmetic.
  if (v[0].w != v[1].w || v[1].w != v[2].w) return;
  s.inverse_w = {1 / v[0].w, 0, 0};
  if (v[0].z == v[1].z && v[1].z == v[2].z) s.depth = {v[0].z / v[0].w, 0, 0};
}

void set_errors(Shape& s, const Polygon& p, const std::array<ClipVertex, 3>& v, const Target& t, double twice_area) {
  std::vector<Point> outline;
  double longest = 0;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    outline.push_back({a.x, a.y});
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
    const bool on_near = p.vertices[i].on_near;
    double& moved = on_near ? s.near_moved : s.moved;
    moved = std::max(moved, a.moved);
    // Of a corner on the near plane, whose depth is 1, both errors count by the pixel's depth.
    s.relative_error = std::max(s.relative_error, a.relative_error + (on_near ? a.z_error : 0));
    if (!on_near) s.z_error = std::max(s.z_error, a.z_error);
  }
  s.height = std::fabs(twice_area) / longest - 2 * s.moved;
  if (!(s.height > 2 * s.moved)) s.planes_known = false;
  s.stretch = stretch_at(s, 0, 0, 0);
  s.rounding = {4 * t.width, 4 * t.height};
  widen_rounding(s, clip_box(outline, -kGuard, -kGuard, kGuard, kGuard));
  const std::vector<Point> drawn = clip_box(outline, t.left, t.top, t.right, t.bottom);
  widen_rounding(s, drawn);
  if (s.whole) return;
  double inverse_w = 0;
  for (const Point& d : drawn) inverse_w = std::max(inverse_w, evaluate(s, s.inverse_w, d.x, d.y));
  s.side_moved = side_moved(v[0], v[1], v[2], inverse_w, t);
  add_pieces(s, drawn);
}

void set_bounds(Shape& s, const Polygon& p, const Target& t) {
  double x_low = 1e30, y_low = 1e30, x_high = -1e30, y_high = -1e30;
  for (uint32_t i = 0; i < p.count; ++i) {
    const Corner& c = p.corners[i];
    x_low = std::min(x_low, c.x - c.moved), x_high = std::max(x_high, c.x + c.moved);
    y_low = std::min(y_low, c.y - c.moved), y_high = std::max(y_high, c.y + c.moved);
  }
  const auto pixel = [](double v, double low, double high) { return static_cast<uint32_t>(std::clamp(v, low, high)); };
  const bool all = s.anywhere;
  s.x_first = pixel(all ? t.left : std::ceil(x_low - 0.5), t.left, t.right);
  s.x_end = pixel(all ? t.right : std::floor(x_high + 0.5), t.left, t.right);
  s.y_first = pixel(all ? t.top : std::ceil(y_low - 0.5), t.top, t.bottom);
  s.y_end = pixel(all ? t.bottom : std::floor(y_high + 0.5), t.top, t.bottom);
}

Edge edge_of(const Polygon& p, uint32_t i, const Ends& ends, bool clockwise) {
  const Corner &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
  const auto [from, to] = p.vertices[i].edge;
  Edge e = {a.snapped_x, a.snapped_y, b.snapped_x, b.snapped_y, ends.a, ends.b, from, to};
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
  s.left = t.left, s.top = t.top, s.right = t.right, s.bottom = t.bottom;
  const Polygon p = clip_depth(v, t);
  if (p.count == 0) return s;
  double error = 0, sum = 0, least_w = std::numeric_limits<double>::infinity();
  for (const ClipVertex& c : v) {
    s.crosses_near |= before_near(c) < c.w_error + c.z_error;
    s.crosses_far |= before_far(c) < c.z_error;
    error = std::max(error, c.w_error + c.z_error);
    sum += std::fabs(c.w) + std::fabs(c.z);
  }
  for (uint32_t i = 0; i < p.count; ++i) {
    least_w = std::min(least_w, p.vertices[i].at.w);
    s.anywhere |= !(p.vertices[i].at.w > 0);
  }
  if (s.crosses_near || s.crosses_far) s.cut_slack = (4 * u * sum + 2 * error) / least_w;
  set_bounds(s, p, t);
  if (s.x_first >= s.x_end || s.y_first >= s.y_end) return s;
  if (s.anywhere) {
    s.planes_known = false;
    s.edges.emplace_back();
    return s;
  }

  std::array<Ends, 5> ends = {};
  std::array<double, 5> moved = {};
  for (uint32_t i = 0; i < p.count; ++i) {
    ends[i] = ends_of(p, i, v, t);
    moved[i] = std::max(moved[i], ends[i].a);
    moved[(i + 1) % p.count] = std::max(moved[(i + 1) % p.count], ends[i].b);
    s.relative_error = std::max(s.relative_error, ends[i].relative);
    s.z_error = std::max(s.z_error, ends[i].depth);
  }
  widen_near_cuts(p, t, ends);
  const Area area = area_of(p, moved);
  const double doubt = area.error + 0x1p-48 * std::fabs(area.twice);
  if (area.error == 0 && area.twice == 0) return s;
  s.certain = std::fabs(area.twice) > doubt;
  s.whole = !s.crosses_near && !s.crosses_far;
  for (uint32_t i = 0; i < p.count; ++i) s.whole = s.whole && inside_target(p.corners[i], t);
  set_planes(s, v, t);
  set_errors(s, p, v, t, area.twice);
  const auto is_cut = [&](uint32_t i) { return p.vertices[i].edge.first == p.vertices[i].edge.second; };
  for (const bool clockwise : {true, false}) {
    if (s.certain && (area.twice > 0) != clockwise) continue;
    // Clockwise in framebuffer coordinates is the back of a surface that was not mirrored.
    if (facing == (clockwise ? Facing::cull_back : Facing::cull_front)) continue;
    for (uint32_t i = 0; i < p.count; ++i)
      if (!is_cut(i)) s.edges.push_back(edge_of(p, i, ends[i], clockwise));
  }
  for (uint32_t i = 0; i < p.count; ++i) s.edges_a_side += !is_cut(i);
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
  if (s.anywhere) return {Cover::maybe, kNoEdge};
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
  const double inside = std::min({x - s.left, y - s.top, s.right - x, s.bottom - y});
  if (best.cover == Cover::in && inside < s.side_moved) return {Cover::maybe, kNoEdge};
  return best;
}

}  // namespace assay::raster
