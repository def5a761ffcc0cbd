#include "harness/interpolation_oracle.h"

#include <algorithm>

#include "harness/formats/visibility.h"

namespace assay::interpolation {

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

}  // namespace

void set_corner(Triangle& t, int k, const SurfaceRecord& s, const vec3& p) {
  t.corners[k] = {along(s.clip_x, p, t.flushed[k]), along(s.clip_y, p, t.flushed[k]), along(s.clip_w, p, t.flushed[k])};
}

void place(Triangle& t, uvec2 pixel, uvec2 viewport) {
  t.half_width = 0.5 * viewport.x, t.half_height = 0.5 * viewport.y;
  t.offset_x = pixel.x + 0.5 - t.half_width, t.offset_y = pixel.y + 0.5 - t.half_height;
}

std::optional<ShownTriangle> shown_triangle(uvec2 texel, std::span<const vec3> positions,
                                            std::span<const uint32_t> indices,
                                            std::span<const SurfaceRecord> surfaces) {
  if (texel == uvec2(kVisibilityNone)) return {};
  if (surfaces.empty() || indices.empty() || positions.empty()) return {};
  const auto last = [](uint32_t i, size_t count) { return std::min(i, static_cast<uint32_t>(count) - 1); };
  ShownTriangle t;
  t.surface = &surfaces[last(texel.y & kVisibilitySurfaceMask, surfaces.size())];
  for (int k = 0; k < 3; ++k) {
    const uint32_t index = indices[last(t.surface->first_index + 3 * texel.x + static_cast<uint>(k), indices.size())];
    t.vertices[k] = last(index + t.surface->vertex_offset, positions.size());
    set_corner(t, k, *t.surface, positions[t.vertices[k]]);
  }
  t.flipped = (texel.y & kVisibilityFlipped) != 0;
  return t;
}

RoundedWide exact(double v) { return {Wide(v), 0}; }

Hit thirds() {
  const RoundedDouble third = {1.0 / 3, u / 3};
  return {.determined = true, .weights = {third, third, third}, .derivatives = {}};
}

std::optional<Few<Corner, 3>> scaled(const Triangle& t) {
  if (t.corners[0] == t.corners[1] && t.corners[0] == t.corners[2]) return {};
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

Recentred recentred_by_compensation(const Triangle& t, const Few<Corner, 3>& corners) {
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

Hit hit_compensated(const Triangle& t) {
  const auto corners = scaled(t);
  return corners ? hit_compensated(recentred_by_compensation(t, *corners), *corners) : thirds();
}

Direction axis(int k) {
  Direction d = {.determined = true, .xyz = {}};
  d.xyz[k].value = 1;
  return d;
}

namespace {

using Vector = Few<RoundedDouble, 3>;

Vector exactly(const vec3& v) { return {RoundedDouble{v.x, 0}, {v.y, 0}, {v.z, 0}}; }
Vector row(const vec4& r) { return exactly(vec3(r)); }
RoundedDouble dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector operator-(const Vector& v) { return {-v[0], -v[1], -v[2]}; }

// Where a float shader finds no direction it takes `fallback`.
Direction direction_or(const Vector& v, int fallback) {
  double largest = 0, error = 0, length = 0;
  bool zero = true;
  for (const RoundedDouble& c : v) {
    if (!std::isfinite(c.value) || !std::isfinite(c.error)) return {};
    largest = std::max(largest, std::fabs(c.value));
    error = std::hypot(error, c.error), length = std::hypot(length, c.value);
    zero = zero && is_zero(c);
  }
  if (zero) return axis(fallback);
  // Past a quarter of its length the bound below fails; and at 2^+-100 the shader gives up, in its own rounding.
  if (!(error < 0.25 * length) || largest < 0x1p-99 || largest > 0x1p99) return {};
  // A vector moved by r of its length turns by asin(r): a chord of at most 1.04 r while r < 1/4. Then the squared
  // length is a sum of three (3u, half of it in the root), inversesqrt has 2 ulp, the product rounds.
  Direction d = {.determined = true, .xyz = {}};
  const double moved = 1.04 * error / length;
  for (int k = 0; k < 3; ++k) {
    if (is_zero(v[k])) continue;
    const double c = v[k].value / length;
    d.xyz[k] = {c, moved + 7 * u * std::fabs(c) + kFlushed};
  }
  return d;
}

}  // namespace

TangentFrame frame_of(const SurfaceRecord& s, bool flipped, const Few<const VertexAttributes*, 3>& vertices,
                      const Hit& h) {
  TangentFrame f;
  f.left_handed = (vertices[0]->tangent.w < 0) != flipped;
  if (!h.determined) return f;
  Vector n = {}, along_u = {};
  for (int k = 0; k < 3; ++k) {
    const Vector normal = exactly(vertices[k]->normal), tangent = exactly(vec3(vertices[k]->tangent));
    for (int i = 0; i < 3; ++i) {
      n[i] = n[i] + h.weights[k] * normal[i];
      along_u[i] = along_u[i] + h.weights[k] * tangent[i];
    }
  }
  const Vector x = row(s.world_x), y = row(s.world_y), z = row(s.world_z);
  const Vector world = {dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n)};
  f.normal = direction_or(flipped ? -world : world, 2);
  f.tangent = direction_or({dot(x, along_u), dot(y, along_u), dot(z, along_u)}, 0);
  return f;
}

}  // namespace assay::interpolation
