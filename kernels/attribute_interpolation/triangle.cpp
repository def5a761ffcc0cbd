#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

Scene scene_of(const Case& c) {
  return {c.params<AttributeParams>(),        c.input<uvec2>("visibility"),
          c.input<vec3>("positions"),         c.input<VertexAttributes>("attributes"),
          c.input<uint>("indices"),           c.input<SurfaceRecord>("surfaces"),
          c.input<ClipSample>("clip_samples")};
}

std::optional<SeenTriangle> triangle_at(const Scene& s, uint64_t pixel) {
  SeenTriangle t;
  if (s.params.clip_samples > 0) {
    if (pixel >= s.params.clip_samples) return {};
    const ClipSample& c = s.clip_samples[pixel];
    t.corners = {c.v0, c.v1, c.v2};
    place(t, c.pixel, c.viewport);
    return t;
  }
  const auto shown = shown_triangle(s.visibility[pixel], s.positions, s.indices, s.surfaces);
  if (!shown) return {};
  static_cast<ShownTriangle&>(t) = *shown;
  for (int k = 0; k < 3; ++k) t.attributes[k] = &s.attributes[t.vertices[k]];
  place(t, uvec2(pixel % s.params.width, pixel / s.params.width), uvec2(s.params.width, s.params.height));
  return t;
}

const char* name_of(Formula f) {
  constexpr const char* kNames[] = {"compensated", "paired", "edges"};
  return kNames[static_cast<int>(f)];
}

namespace {

// Sums and products of pairs of floats: relative errors of 3u^2 and 7u^2 (Joldes, Muller, Popescu 2017, algorithms 6
// and 10), products of floats as pairs none.
RoundedWide pair_sum(const RoundedWide& a, const RoundedWide& b) {
  const Wide v = a.value + b.value;
  const double error = a.error + b.error;
  return {v, error + 3.01 * u * u * (magnitude(v) + error) + 8 * kFlushed};
}
RoundedWide pair_product(const RoundedWide& a, const RoundedWide& b) {
  const Wide v = a.value * b.value;
  const double error = product_error(a, b);
  return {v, error + 7 * u * u * (magnitude(v) + error) + 8 * kFlushed};
}
RoundedWide high(const RoundedWide& a) { return rounded<Wide>(a.value, a.error); }

Hit hit_in_pairs(const SeenTriangle& t, const Few<Corner, 3>& corners) {
  const auto recentre = [](double h, const RoundedWide& v, double o, const RoundedWide& w) {
    const RoundedWide a = {Wide(h) * v.value, h * v.error + 8 * kFlushed},
                      b = {Wide(o) * w.value, std::fabs(o) * w.error + 8 * kFlushed};
    return pair_sum(a, -b);
  };
  Three x, y, areas, rounded_areas;
  for (int k = 0; k < 3; ++k) {
    x[k] = recentre(t.half_width, corners[k].x, t.offset_x, corners[k].w);
    y[k] = recentre(t.half_height, corners[k].y, t.offset_y, corners[k].w);
  }
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    areas[k] = pair_sum(pair_product(x[a], y[b]), -pair_product(x[b], y[a]));
    rounded_areas[k] = high(areas[k]);
  }
  const RoundedWide area = high(pair_sum(pair_sum(areas[0], areas[1]), areas[2]));
  return weigh(rounded_areas, area,
               {high(pair_sum(y[2], -y[0])), high(pair_sum(y[0], -y[1])), high(pair_sum(x[0], -x[2])),
                high(pair_sum(x[1], -x[0]))},
               corners);
}

// The larger error of two answers with the same exact values.
Hit either(const Hit& a, const Hit& b) {
  if (!a.determined || !b.determined) return {};
  Hit h = a;
  for (int k = 0; k < 3; ++k) h.weights[k].error = std::max(a.weights[k].error, b.weights[k].error);
  for (int k = 0; k < 4; ++k) h.derivatives[k].error = std::max(a.derivatives[k].error, b.derivatives[k].error);
  return h;
}

// The shader decides by sum |x_a y_b| > kWellConditioned * |area|, six products and five sums: 11u of it.
Hit hit_paired(const SeenTriangle& t, const Few<Corner, 3>& corners) {
  const Recentred r = recentred_by_compensation(t, corners);
  double least = 0, most = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      if (a == b) continue;
      const double product = magnitude(r.x[a].value) * magnitude(r.y[b].value),
                   error = product_error(r.x[a], r.y[b]) + kFlushed;
      least += product - error, most += product + error;
    }
  least *= 1 - 12 * u, most *= 1 + 12 * u;
  const double area = magnitude(r.area.value);
  if (most < kWellConditioned * (area - r.area.error)) return hit_compensated(r, corners);
  if (least > kWellConditioned * (area + r.area.error)) return hit_in_pairs(t, corners);
  return either(hit_compensated(r, corners), hit_in_pairs(t, corners));
}

// One vertex and two edges; multiply-adds that may or may not be fused.
Hit hit_by_edges(const SeenTriangle& t, const Few<Corner, 3>& c) {
  const Corner v = c[0], a = {c[1].x - v.x, c[1].y - v.y, c[1].w - v.w}, b = {c[2].x - v.x, c[2].y - v.y, c[2].w - v.w};
  const RoundedWide hx = exact(t.half_width), hy = exact(t.half_height), ox = exact(t.offset_x), oy = exact(t.offset_y);
  const RoundedWide vx = hx * v.x - ox * v.w, vy = hy * v.y - oy * v.w, ax = hx * a.x - ox * a.w,
                    ay = hy * a.y - oy * a.w, bx = hx * b.x - ox * b.w, by = hy * b.y - oy * b.w;
  const RoundedWide area = ax * by - bx * ay;
  Hit h = {.clamped = false, .weights = {}, .derivatives = {}};
  if (!(magnitude(area.value) - area.error > 2.0 * kSmallestArea)) return h;
  h.determined = true;
  h.clockwise = area.value > 0;
  const RoundedWide inverse = reciprocal(area);
  const RoundedWide wa = (bx * vy - vx * by) * inverse, wb = (vx * ay - ax * vy) * inverse;
  h.weights = {narrowed(exact(1) - wa - wb), narrowed(wa), narrowed(wb)};
  const RoundedWide scale = not_negative(v.w + wa * a.w + wb * b.w) * inverse;
  h.derivatives = {narrowed(scale * by), narrowed(-(scale * ay)), narrowed(-(scale * bx)), narrowed(scale * ax)};
  return h;
}

}  // namespace

Hit hit(const SeenTriangle& t, Formula f) {
  const auto corners = scaled(t);
  if (!corners) return thirds();
  if (f == Formula::paired) return hit_paired(t, *corners);
  if (f == Formula::edges) return hit_by_edges(t, *corners);
  return hit_compensated(recentred_by_compensation(t, *corners), *corners);
}

TangentFrame frame_of(const SeenTriangle& t, const Hit& h) {
  if (!t.surface) return {axis(2), axis(0), false};
  return frame_of(*t.surface, t.flipped, t.attributes, h);
}

Few<RoundedDouble, 2> lambert(const Direction& d) {
  Few<RoundedDouble, 2> e;
  const double z = std::fabs(d.xyz[2].value), spread = std::sqrt(1 + z);
  for (int k = 0; k < 2; ++k) {
    if (is_zero(d.xyz[k])) continue;
    // The divisor is 1 or more, and its root changes by half of what z does, or less; a sum, 2 ulp of inversesqrt and a
    // product are 6u.
    const double c = d.xyz[k].value / spread;
    e[k] = {c, d.xyz[k].error + 0.5 * std::fabs(c) * d.xyz[2].error + 6 * u * std::fabs(c)};
  }
  return e;
}

}  // namespace assay::attribute_interpolation
