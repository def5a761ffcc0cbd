#include "kernels/attribute_interpolation/tangent_frame.h"

namespace assay::attribute_interpolation {

namespace {

using Vector = Few<RoundedDouble, 3>;

Vector exact(const vec3& v) { return {RoundedDouble{v.x, 0}, {v.y, 0}, {v.z, 0}}; }
Vector row(const vec4& r) { return exact(vec3(r)); }
RoundedDouble dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector operator-(const Vector& v) { return {-v[0], -v[1], -v[2]}; }

Direction axis(int k) {
  Direction d = {.determined = true, .xyz = {}};
  d.xyz[k].value = 1;
  return d;
}

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

TangentFrame frame_of(const SeenTriangle& t, const Hit& h) {
  if (!t.surface) return {axis(2), axis(0), false};
  TangentFrame f;
  f.left_handed = (t.attributes[0]->tangent.w < 0) != t.flipped;
  if (!h.determined) return f;
  Vector n = {}, along_u = {};
  for (int k = 0; k < 3; ++k) {
    const Vector normal = exact(t.attributes[k]->normal), tangent = exact(vec3(t.attributes[k]->tangent));
    for (int i = 0; i < 3; ++i) {
      n[i] = n[i] + h.weights[k] * normal[i];
      along_u[i] = along_u[i] + h.weights[k] * tangent[i];
    }
  }
  const Vector x = row(t.surface->world_x), y = row(t.surface->world_y), z = row(t.surface->world_z);
  const Vector world = {dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n)};
  f.normal = direction_or(t.flipped ? -world : world, 2);
  f.tangent = direction_or({dot(x, along_u), dot(y, along_u), dot(z, along_u)}, 0);
  return f;
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
