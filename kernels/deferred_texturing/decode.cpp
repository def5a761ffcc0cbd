#include "kernels/deferred_texturing/decode.h"

namespace assay::deferred_texturing {

namespace {

// Vulkan bounds the unpacking functions nowhere; a product with a rounded reciprocal is 1.5 ulp off.
constexpr double kUnpack = 2;

Range unorm16(uint32_t code) { return rounded((code & 0xffffu) / 65535.0, kUnpack); }
Range snorm16(uint32_t code) {
  return rounded(std::max(static_cast<int16_t>(code & 0xffffu) / 32767.0, -1.0), kUnpack);
}

// Lambert's azimuthal equal-area projection, the hemisphere by a flag.
Range3 direction(uint32_t code, bool negative) {
  const Range x = snorm16(code), y = snorm16(code >> 16);
  const Range r = clamped(square(x) + square(y), 0, 1);
  const Range s = root(2.0 - r), z = 1.0 - r;
  return {x * s, y * s, negative ? -z : z};
}

// Thirteen bits of two's complement under a shared exponent: exact in fp32.
Range derivative(uint32_t word, uint32_t shift, uint32_t exponent) {
  const auto mantissa = static_cast<int32_t>(word << (19 - shift)) >> 19;
  if (exponent == 0) return 0.0;
  return std::ldexp(mantissa, static_cast<int>(exponent) - kAttributeExponentBias);
}

Range around(const interpolation::RoundedDouble& r) { return {r.value - r.error, r.value + r.error}; }
// In the simplex, but for the rounding of the division and the product.
Range weight(const interpolation::Hit& h, int k) {
  const Range any = {0, 1 + 8 * kUnitRoundoff};
  return h.determined ? clamped(around(h.weights[k]), any.low, any.high) : any;
}
Range derivative(const interpolation::Hit& h, int k) { return h.determined ? around(h.derivatives[k]) : unknown(); }
Range3 direction(const interpolation::Direction& d) {
  Range3 r;
  for (int k = 0; k < 3; ++k) r[static_cast<size_t>(k)] = d.determined ? around(d.xyz[k]) : Range(-1.001, 1.001);
  return r;
}

Range usable_uv(Range r) {
  if (r.is_nan()) return 0.0;
  const double most = std::max(std::fabs(r.low), std::fabs(r.high));
  if (most < kLargestUv || most == kInfinite) return r;
  const bool is_beyond = r.low >= kLargestUv || r.high <= -kLargestUv;
  return is_beyond ? Range(0.0) : hull(clamped(r, -kLargestUv, kLargestUv), 0.0);
}

Range usable_gradient(Range r) {
  if (r.is_nan()) return double{kLargestGradient};
  if (std::max(std::fabs(r.low), std::fabs(r.high)) < kLargestGradient) return r;
  const bool is_beyond = r.low >= kLargestGradient || r.high <= -kLargestGradient;
  return is_beyond ? Range(kLargestGradient)
                   : hull(clamped(r, -kLargestGradient, kLargestGradient), double{kLargestGradient});
}

}  // namespace

PixelAttributes decoded(uint32_t barycentrics, uvec2 derivatives, uvec2 tangent_frame) {
  const uint32_t exponent = derivatives.x >> 26 | (derivatives.y >> 26 & 3u) << 6, flags = derivatives.y >> 28;
  PixelAttributes a;
  a.weight_1 = unorm16(barycentrics), a.weight_2 = unorm16(barycentrics >> 16);
  a.weight_1_dx = derivative(derivatives.x, 0, exponent), a.weight_2_dx = derivative(derivatives.x, 13, exponent);
  a.weight_1_dy = derivative(derivatives.y, 0, exponent), a.weight_2_dy = derivative(derivatives.y, 13, exponent);
  a.normal = direction(tangent_frame.x, (flags & kAttributeNormalNegative) != 0);
  a.tangent = direction(tangent_frame.y, (flags & kAttributeTangentNegative) != 0);
  a.left_handed = (flags & kAttributeLeftHanded) != 0, a.front_facing = (flags & kAttributeFrontFacing) != 0;
  return a;
}

PixelAttributes interpolated(const interpolation::Triangle& t, const SurfaceRecord& s, bool flipped,
                             const interpolation::Few<const VertexAttributes*, 3>& vertices) {
  const interpolation::Hit h = interpolation::hit_compensated(t);
  const interpolation::TangentFrame f = interpolation::frame_of(s, flipped, vertices, h);
  PixelAttributes a;
  a.weight_1 = weight(h, 1), a.weight_2 = weight(h, 2);
  a.weight_1_dx = derivative(h, 0), a.weight_2_dx = derivative(h, 1);
  a.weight_1_dy = derivative(h, 2), a.weight_2_dy = derivative(h, 3);
  a.normal = direction(f.normal), a.tangent = direction(f.tangent);
  a.left_handed = f.left_handed, a.front_facing = h.clockwise == flipped;
  a.determined = h.determined && f.normal.determined && f.tangent.determined;
  return a;
}

RangeFootprint usable(const RangeFootprint& f) {
  return {usable_uv(f.u),          usable_uv(f.v),          usable_gradient(f.u_dx),
          usable_gradient(f.v_dx), usable_gradient(f.u_dy), usable_gradient(f.v_dy)};
}

RangeFootprint footprint_of(const std::array<vec2, 3>& uv, const PixelAttributes& a) {
  const auto along = [&](int axis, Range w1, Range w2) {
    const Range origin = double{uv[0][axis]};
    return w1 * (double{uv[1][axis]} - origin) + w2 * (double{uv[2][axis]} - origin);
  };
  const auto at = [&](int axis) { return double{uv[0][axis]} + along(axis, a.weight_1, a.weight_2); };
  return usable({at(0), at(1), along(0, a.weight_1_dx, a.weight_2_dx), along(1, a.weight_1_dx, a.weight_2_dx),
                 along(0, a.weight_1_dy, a.weight_2_dy), along(1, a.weight_1_dy, a.weight_2_dy)});
}

RangeFootprint scaled(const RangeFootprint& f, float by) {
  const Range s = double{by};
  return usable({s * f.u, s * f.v, s * f.u_dx, s * f.v_dx, s * f.u_dy, s * f.v_dy});
}

}  // namespace assay::deferred_texturing
