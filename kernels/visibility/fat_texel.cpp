#include "kernels/visibility/fat_texel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace assay::visibility {

using namespace raster;

namespace {

constexpr double u = kUnitRoundoff;
constexpr double kPi = 3.14159265358979323846;
constexpr double kUnknown = std::numeric_limits<double>::infinity();
// Half a step of 1/1023 in x and in y moves (x, y, 1 - |x| - |y|) by sqrt(6) / 2046, and its length is 1/sqrt(3) or
// more.
const double kOctahedral = std::sqrt(18.0) / 2046 + 32 * u;
// Half a step of a turn, and atan(y, x), 4096 ulp of at most 4 by Vulkan's table.
constexpr double kAngle = kPi / 512 + 4096 * 4 * u;
constexpr double kPixelReach = 1.5;  // pixels: a quad's other pixels are at most sqrt(2) away

double derivative_of(uint32_t code) {
  const int c = static_cast<int>(code & kFatCodes);
  const double magnitude = c == 0 ? 0 : std::ldexp(4 + (c - 1) % 4, (c - 1) / 4 + kFatLowestExponent - 2);
  return (code & 0x80u) != 0 ? -magnitude : magnitude;
}

// The nearest value that a code stands for: two bits of mantissa behind the leading one, halves away from zero.
float quantised(double v) {
  const double a = std::fabs(v);
  const double largest = derivative_of(kFatCodes);
  if (!(a < largest)) return static_cast<float>(std::copysign(largest, v));
  int exponent;
  const double mantissa = std::frexp(a, &exponent);  // [1/2, 1)
  const double rounded = std::ldexp(std::floor(mantissa * 8 + 0.5), exponent - 3);
  return static_cast<float>(rounded < std::ldexp(1.0, kFatLowestExponent) ? 0 : std::copysign(rounded, v));
}

struct Vector {
  double x, y, z;
  double length() const { return std::sqrt(x * x + y * y + z * z); }
};
Vector operator*(double s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector row(const vec4& r) { return {r.x, r.y, r.z}; }
Vector vector(const vec3& v) { return {v.x, v.y, v.z}; }
vec3 narrow(const Vector& v) { return vec3(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)); }

Vector normal_of(uint32_t code) {
  const auto steps = [](uint32_t bits) { return static_cast<double>(bits & 2047u) - double{kFatNormalSteps}; };
  Vector n = {steps(code), steps(code >> 11), 0};
  n.z = kFatNormalSteps - std::fabs(n.x) - std::fabs(n.y);
  if (n.z < 0) {
    const double x = (kFatNormalSteps - std::fabs(n.y)) * (n.x < 0 ? -1 : 1),
                 y = (kFatNormalSteps - std::fabs(n.x)) * (n.y < 0 ? -1 : 1);
    n.x = x, n.y = y;
  }
  return 1 / n.length() * n;
}

// Perpendicular axes from which the tangent's angle counts: x and y of the frame that turns +z (or -z) on to the
// normal.
Vector tangent_of(const Vector& n, uint32_t code) {
  const double s = n.z < 0 ? -1 : 1, a = -1 / (s + n.z), b = n.x * n.y * a;
  const Vector first = {1 + s * n.x * n.x * a, s * b, -s * n.x}, second = {b, s + n.y * n.y * a, -n.y};
  const double angle = 2 * kPi * (code >> 22 & 511u) / double{kFatTurnSteps};
  return std::cos(angle) * first + std::sin(angle) * second;
}

FatFields unpacked(uvec2 texel) {
  const auto derivative = [&](uint32_t byte) { return static_cast<float>(derivative_of(texel.x >> 8 * byte & 255u)); };
  const Vector n = normal_of(texel.y);
  return {derivative(0),
          derivative(1),
          derivative(2),
          derivative(3),
          narrow(n),
          narrow(tangent_of(n, texel.y)),
          (texel.y & kNegativeHand) != 0 ? -1.0f : 1.0f};
}

void append(Bytes& to, const FatFields& f) {
  const auto* p = reinterpret_cast<const std::byte*>(&f);
  to.insert(to.end(), p, p + sizeof f);
}

// Differences across a quad: those of either row for x, of either column for y; Vulkan leaves the choice open.
Interval difference(const std::array<Attribute, 4>& quad, uint32_t a0, uint32_t a1, uint32_t b0, uint32_t b1) {
  Interval hull = {kUnknown, -kUnknown};
  for (const auto& [from, to] : {std::pair{a0, a1}, std::pair{b0, b1}}) {
    const double d = quad[to].value - quad[from].value;
    const double error = quad[to].error + quad[from].error + 2 * u * std::fabs(d);
    hull = {std::min(hull.low, d - error), std::max(hull.high, d + error)};
  }
  if (!(hull.low <= hull.high)) return {-kUnknown, kUnknown};
  return hull;
}

// A vector attribute at the pixel; `error` bounds the length of what may be wrong with it.
struct VectorAttribute {
  Vector value;
  double error;
};
VectorAttribute vector_at(const Shape& s, const std::array<Vector, 3>& v, double vertex_error, double x, double y) {
  const Attribute a = attribute_at(s, {v[0].x, v[1].x, v[2].x}, x, y),
                  b = attribute_at(s, {v[0].y, v[1].y, v[2].y}, x, y),
                  c = attribute_at(s, {v[0].z, v[1].z, v[2].z}, x, y);
  return {{a.value, b.value, c.value}, Vector{a.error, b.error, c.error}.length() + s.stretch * vertex_error};
}

struct Frame {
  Vector normal, tangent;
  double normal_error = kUnknown, tangent_error = kUnknown;
};

Frame frame_at(const Shape& s, const std::array<VertexAttributes, 3>& v, const SurfaceRecord& surface, double x,
               double y) {
  const Vector r0 = row(surface.world_x), r1 = row(surface.world_y), r2 = row(surface.world_z);
  const Vector c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
  const double side = (surface.flags & kSurfaceFlipped) != 0 ? -1 : 1;
  // Cofactors are differences of two products (3u of |r||r'|, both terms), dot products of three terms (3u).
  const double cofactor_scale = 2 * (r1.length() * r2.length() + r2.length() * r0.length() + r0.length() * r1.length());
  const double tangent_scale = r0.length() + r1.length() + r2.length();
  std::array<Vector, 3> normals, tangents;
  double longest_normal = 0, longest_tangent = 0;
  for (uint32_t k = 0; k < 3; ++k) {
    const Vector n = vector(v[k].normal), t = {v[k].tangent.x, v[k].tangent.y, v[k].tangent.z};
    normals[k] = side * Vector{dot(c0, n), dot(c1, n), dot(c2, n)};
    tangents[k] = {dot(r0, t), dot(r1, t), dot(r2, t)};
    longest_normal = std::max(longest_normal, n.length()), longest_tangent = std::max(longest_tangent, t.length());
  }
  const VectorAttribute n = vector_at(s, normals, 6 * u * cofactor_scale * longest_normal, x, y);
  const VectorAttribute t = vector_at(s, tangents, 3 * u * tangent_scale * longest_tangent, x, y);
  Frame f;
  const double n_length = n.value.length();
  if (!(n.error < 0.25 * n_length)) return f;
  f.normal = 1 / n_length * n.value;
  f.normal_error = 2 * n.error / n_length + kOctahedral;
  // The tangent's angle is that of its projection along the stored normal, which turns the plane by normal_error.
  const Vector flat = t.value + (-dot(t.value, f.normal)) * f.normal;
  const double error = t.error + (2 * f.normal_error + 16 * u) * t.value.length();
  if (!(error < 0.25 * flat.length())) return f;
  f.tangent = 1 / flat.length() * flat;
  f.tangent_error = 2 * error / flat.length() + kAngle;
  return f;
}

Interval component(double v, double error) {
  if (!(error < 2)) return {-1.001, 1.001};  // any unit vector
  return {v - error, v + error};
}

}  // namespace

Bytes unpack_fat(std::span<const std::byte> texels) {
  Bytes out;
  out.reserve(texels.size() / sizeof(uvec2) * sizeof(FatFields));
  for (size_t i = 0; i + sizeof(uvec2) <= texels.size(); i += sizeof(uvec2)) {
    uvec2 texel;
    std::memcpy(&texel, texels.data() + i, sizeof texel);
    append(out, unpacked(texel));
  }
  return out;
}

void append_cleared(Expected& e) {
  append(e.low, unpacked(uvec2(0, 0)));
  append(e.high, unpacked(uvec2(0, 0)));
}

void append_fat(Expected& e, const Shape& s, const std::array<VertexAttributes, 3>& v, const SurfaceRecord& surface,
                uint32_t x, uint32_t y) {
  FatFields low, high;
  const double quad_x = (x & ~1u) + 0.5, quad_y = (y & ~1u) + 0.5;
  const auto derivatives = [&](double a, double b, double c, float& low_dx, float& high_dx, float& low_dy,
                               float& high_dy) {
    std::array<Attribute, 4> quad;
    for (uint32_t i = 0; i < 4; ++i)
      quad[i] = attribute_at(s, {a, b, c}, quad_x + (i & 1u), quad_y + (i >> 1), kPixelReach);
    const Interval d_dx = difference(quad, 0, 1, 2, 3), d_dy = difference(quad, 0, 2, 1, 3);
    low_dx = quantised(d_dx.low), high_dx = quantised(d_dx.high);
    low_dy = quantised(d_dy.low), high_dy = quantised(d_dy.high);
  };
  derivatives(v[0].uv.x, v[1].uv.x, v[2].uv.x, low.du_dx, high.du_dx, low.du_dy, high.du_dy);
  derivatives(v[0].uv.y, v[1].uv.y, v[2].uv.y, low.dv_dx, high.dv_dx, low.dv_dy, high.dv_dy);
  const Frame f = frame_at(s, v, surface, x + 0.5, y + 0.5);
  const auto bound = [](const Vector& value, double error, vec3& to_low, vec3& to_high) {
    const Interval a = component(value.x, error), b = component(value.y, error), c = component(value.z, error);
    to_low = narrow({a.low, b.low, c.low}), to_high = narrow({a.high, b.high, c.high});
  };
  bound(f.normal, f.normal_error, low.normal, high.normal);
  bound(f.tangent, f.tangent_error, low.tangent, high.tangent);
  // Flat: the first vertex's.
  const bool negative = ((surface.flags & kSurfaceFlipped) != 0) != (v[0].tangent.w < 0);
  low.handedness = high.handedness = negative && v[0].tangent.w != 0 ? -1.0f : 1.0f;
  append(e.low, low);
  append(e.high, high);
}

}  // namespace assay::visibility
