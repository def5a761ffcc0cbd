#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

Scene scene_of(const Case& c) {
  return {c.params<AttributeParams>(),        c.input<uvec2>("visibility"),
          c.input<vec3>("positions"),         c.input<VertexAttributes>("attributes"),
          c.input<uint>("indices"),           c.input<SurfaceRecord>("surfaces"),
          c.input<ClipSample>("clip_samples")};
}

namespace {

// float * float is exact in double, and float + float, rounded to double and then to float, is as if rounded once
// (Figueroa 1995): the roundings of `precise` shader code without a host's fused operations in the way.
float product(float a, float b) { return static_cast<float>(double{a} * b); }
float sum(float a, float b) { return static_cast<float>(double{a} + b); }

// One clip row. What a device that flushes denormals may leave out of it is added to `flushed`.
float along(const vec4& row, const vec3& p, double& flushed) {
  const float terms[] = {product(row.x, p.x), product(row.y, p.y), product(row.z, p.z), row.w};
  float total = terms[0];
  for (int i = 1; i < 4; ++i) total = sum(total, terms[i]);
  const auto is_tiny = [](float v) { return v != 0 && std::fabs(v) < 0x1p-100f; };
  if (std::any_of(std::begin(terms), std::end(terms), is_tiny) || is_tiny(total)) flushed = 8 * kFlushed;
  return total;
}

void place(SeenTriangle& t, uvec2 pixel, uvec2 viewport) {
  t.half_width = 0.5 * viewport.x, t.half_height = 0.5 * viewport.y;
  t.offset_x = pixel.x + 0.5 - t.half_width, t.offset_y = pixel.y + 0.5 - t.half_height;
}

uint last(uint i, uint count) { return std::min(i, count - 1); }

}  // namespace

std::optional<SeenTriangle> triangle_at(const Scene& s, uint64_t pixel) {
  SeenTriangle t;
  if (s.params.clip_samples > 0) {
    if (pixel >= s.params.clip_samples) return {};
    const ClipSample& c = s.clip_samples[pixel];
    t.corners = {c.v0, c.v1, c.v2};
    place(t, c.pixel, c.viewport);
    return t;
  }
  const uvec2 shown = s.visibility[pixel];
  if (shown == uvec2(kVisibilityNone)) return {};
  if (s.params.surfaces == 0 || s.params.indices == 0 || s.params.vertices == 0) return {};
  t.surface = &s.surfaces[last(shown.y & kVisibilitySurfaceMask, s.params.surfaces)];
  for (int k = 0; k < 3; ++k) {
    const uint index = s.indices[last(t.surface->first_index + 3 * shown.x + static_cast<uint>(k), s.params.indices)];
    const uint vertex = last(index + t.surface->vertex_offset, s.params.vertices);
    const vec3 p = s.positions[vertex];
    t.corners[k] = {along(t.surface->clip_x, p, t.flushed[k]), along(t.surface->clip_y, p, t.flushed[k]),
                    along(t.surface->clip_w, p, t.flushed[k])};
    t.attributes[k] = &s.attributes[vertex];
  }
  place(t, uvec2(pixel % s.params.width, pixel / s.params.width), uvec2(s.params.width, s.params.height));
  t.flipped = (shown.y & kVisibilityFlipped) != 0;
  return t;
}

const char* name_of(Formula f) {
  constexpr const char* kNames[] = {"compensated", "paired", "edges"};
  return kNames[static_cast<int>(f)];
}

namespace {

constexpr Hit thirds() {
  const RoundedDouble third = {1.0 / 3, u / 3};
  return {.determined = true, .weights = {third, third, third}, .derivatives = {}};
}

// Corners scaled by a power of two so that the largest coordinate is in 1..2; nothing where that is not promised.
struct Corner {
  RoundedWide x, y, w;
};
std::optional<Few<Corner, 3>> scaled(const SeenTriangle& t) {
  float largest = 0;
  for (const vec3& v : t.corners)
    for (const float c : {v.x, v.y, v.z}) {
      if (!std::isfinite(c)) return {};
      largest = std::max(largest, std::fabs(c));
    }
  constexpr int kBias = 127;
  const int exponent = largest == 0 ? -1000 : std::ilogb(largest);
  if (exponent < static_cast<int>(kSmallestExponent) - kBias || exponent > static_cast<int>(kLargestExponent) - kBias)
    return {};
  Few<Corner, 3> corners;
  const auto scale = [&](float v, int k) -> RoundedWide {
    const double s = std::ldexp(double{v}, -exponent);
    // Exact unless it becomes a denormal, which may be flushed.
    const double lost = s != 0 && std::fabs(s) < 0x1p-100 ? 2 * kFlushed : 0;
    return {Wide(s), lost + std::ldexp(t.flushed[k], -exponent)};
  };
  for (int k = 0; k < 3; ++k)
    corners[k] = {scale(t.corners[k].x, k), scale(t.corners[k].y, k), scale(t.corners[k].z, k)};
  return corners;
}

using Three = Few<RoundedWide, 3>;

// Relative to the pixel's centre, pixels times w: the corners and twice the areas times two w.
struct Recentred {
  Three x, y, areas;
  RoundedWide area;  // their sum
};

// Weights from the three areas, derivatives from them and differences of recentred corners (y2 - y0, y0 - y1, x0 - x2,
// x1 - x0): the last steps of both clamped formulas.
Hit weigh(const Three& areas, const RoundedWide& area, const Few<RoundedWide, 4>& differences,
          const Few<Corner, 3>& corners) {
  Hit h;
  if (!(magnitude(area.value) > area.error)) return h;
  h.clockwise = area.value > 0;
  Three inside;
  for (int k = 0; k < 3; ++k) inside[k] = not_negative(h.clockwise ? areas[k] : -areas[k]);
  const RoundedWide total = inside[0] + inside[1] + inside[2];
  if (!(magnitude(total.value) - total.error > 2.0 * kSmallestArea)) return h;
  h.determined = true;
  const RoundedWide inverse = reciprocal(total);
  RoundedWide w;
  for (int k = 0; k < 3; ++k) {
    const RoundedWide weight = inside[k] * inverse;
    h.weights[k] = narrowed(weight);
    w = w + weight * corners[k].w;
  }
  const RoundedWide scale = not_negative(w) * (h.clockwise ? inverse : -inverse);
  for (int k = 0; k < 4; ++k) h.derivatives[k] = narrowed(scale * differences[k]);
  return h;
}

RoundedWide exact(double v) { return {Wide(v), 0}; }

Recentred recentred_by_compensation(const SeenTriangle& t, const Few<Corner, 3>& corners) {
  Recentred r;
  for (int k = 0; k < 3; ++k) {
    r.x[k] = difference_of_products(exact(t.half_width), corners[k].x, exact(t.offset_x), corners[k].w);
    r.y[k] = difference_of_products(exact(t.half_height), corners[k].y, exact(t.offset_y), corners[k].w);
  }
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    r.areas[k] = difference_of_products(r.x[a], r.y[b], r.x[b], r.y[a]);
  }
  r.area = r.areas[0] + r.areas[1] + r.areas[2];
  return r;
}

Hit hit_compensated(const Recentred& r, const Few<Corner, 3>& corners) {
  return weigh(r.areas, r.area, {r.y[2] - r.y[0], r.y[0] - r.y[1], r.x[0] - r.x[2], r.x[1] - r.x[0]}, corners);
}

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

}  // namespace assay::attribute_interpolation
