#include "harness/raster/alpha.h"

#include <algorithm>
#include <cmath>

namespace assay::raster {

namespace {

constexpr double u = kUnitRoundoff;
constexpr uint32_t kSlots = 16;
// What filtering may add to a unorm texel's interpolation. Vulkan bounds the weights' steps (subTexelPrecisionBits),
// not the arithmetic: texels may be filtered in their own 8 bits, truncated once an axis. That holds for sRGB textures
// too: their alpha is linear, so nothing asks for a wide format. That an
// H200 filters so is inferred (its cuts left the bound that assumed fp32, and keep this one), not measured.
constexpr double kFilter = 2.0 / 255;
constexpr uint32_t kWidestSearch = 8;  // texels a side; beyond, the whole layer's range is taken

struct Layer {
  const std::byte* texels;
  uint32_t width, height;
  double alpha(int64_t x, int64_t y) const {  // repeat
    const auto wrap = [](int64_t i, uint32_t n) { return static_cast<uint64_t>((i % n + n) % n); };
    return std::to_integer<uint32_t>(texels[(wrap(y, height) * width + wrap(x, width)) * 4 + 3]) / 255.0;
  }
};

Interval whole_range(const Layer& l) {
  Interval range = {1, 0};
  for (uint32_t y = 0; y < l.height; ++y)
    for (uint32_t x = 0; x < l.width; ++x) {
      const double a = l.alpha(x, y);
      range = {std::min(range.low, a), std::max(range.high, a)};
    }
  return range;
}

double bilinear(const Layer& l, double x, double y) {
  const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
  const auto i = static_cast<int64_t>(x0), j = static_cast<int64_t>(y0);
  const double top = l.alpha(i, j) * (1 - fx) + l.alpha(i + 1, j) * fx;
  const double bottom = l.alpha(i, j + 1) * (1 - fx) + l.alpha(i + 1, j + 1) * fx;
  return top * (1 - fy) + bottom * fy;
}

// Where a bilinear function may have its extremes along one axis: the ends, and the texel centres between.
struct Stops {
  double at[kWidestSearch + 3];
  uint32_t count = 0;
};
Stops stops(double low, double high) {
  Stops s;
  s.at[s.count++] = low;
  for (double i = std::floor(low) + 1; i < high; ++i) s.at[s.count++] = i;
  s.at[s.count++] = high;
  return s;
}

// Texel coordinates in units of texels, texel centres at integers; the filter's fraction is rounded to the device's
// steps.
Attribute to_texels(const Attribute& a, uint32_t size, uint32_t sub_texel_bits) {
  const double at = a.value * size;
  return {at - 0.5, a.error * size + 3 * u * (std::fabs(at) + 1) + std::ldexp(1.0, -static_cast<int>(sub_texel_bits))};
}

}  // namespace

Attribute attribute_at(const Shape& s, const std::array<double, 3>& values, double x, double y, double outside) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const double inverse_w = evaluate(s, s.inverse_w, x, y);
  if (!s.planes_known || !(inverse_w > 0)) return {0, kUnknown};
  Plane over_w = {};
  for (uint32_t k = 0; k < 3; ++k) {
    over_w.at_origin += values[k] * s.weights[k].at_origin;
    over_w.d_dx += values[k] * s.weights[k].d_dx, over_w.d_dy += values[k] * s.weights[k].d_dy;
  }
  const double value = evaluate(s, over_w, x, y) / inverse_w;
  if (values[0] == values[1] && values[1] == values[2]) return {values[0], 8 * u * std::fabs(values[0])};
  // A corner that is moved carries its value along, so the surface of values tilts by the value's own gradient.
  const double gradient =
      (std::fabs(over_w.d_dx - value * s.inverse_w.d_dx) + std::fabs(over_w.d_dy - value * s.inverse_w.d_dy));
  const double stretch = stretch_at(s, outside, x, y);
  const double rounding =
      rounding_of(s, over_w, value * inverse_w, x, y) + std::fabs(value) * rounding_of(s, s.inverse_w, inverse_w, x, y);
  double carried = 0, largest = 0;  // the corners' own 1/w
  for (uint32_t k = 0; k < 3; ++k) {
    carried += std::fabs(evaluate(s, s.weights[k], x, y) / inverse_w * (values[k] - value)) * s.relative_error;
    largest = std::max(largest, std::fabs(values[k]));
  }
  const double moved = moved_at(s, evaluate(s, s.depth, x, y));
  const double error =
      (stretch * gradient * moved + rounding) / inverse_w + stretch * carried + 10 * u * stretch * largest;
  // 1/w itself is uncertain; where its own error nears it, nothing is known.
  const double slope = std::fabs(s.inverse_w.d_dx) + std::fabs(s.inverse_w.d_dy);
  const double doubt =
      (stretch * slope * moved + rounding_of(s, s.inverse_w, inverse_w, x, y)) / inverse_w + stretch * s.relative_error;
  return doubt < 0.5 ? Attribute{value, error / (1 - doubt)} : Attribute{0, kUnknown};
}

Interval sampled_alpha(const MaterialRecord& m, std::span<const Texture> textures, const Attribute& texcoord_u,
                       const Attribute& texcoord_v, uint32_t sub_texel_bits) {
  const uint32_t array = m.base_texture >> 16;
  if (m.base_texture == kNoTexture || array >= kSlots || array >= textures.size()) return {1, 1};
  const Texture& t = textures[array];
  const uint64_t layer = std::min(m.base_texture & 0xffffu, t.layers - 1);
  const Layer l = {t.bytes.data() + layer * t.width * t.height * 4, t.width, t.height};
  const Attribute x = to_texels(texcoord_u, t.width, sub_texel_bits),
                  y = to_texels(texcoord_v, t.height, sub_texel_bits);
  Interval range = {1, 0};
  if (!(x.error < 0.5 * kWidestSearch) || !(y.error < 0.5 * kWidestSearch) || std::fabs(x.value) > 1e15 ||
      std::fabs(y.value) > 1e15) {
    range = whole_range(l);
  } else {
    const Stops xs = stops(x.value - x.error, x.value + x.error), ys = stops(y.value - y.error, y.value + y.error);
    for (uint32_t j = 0; j < ys.count; ++j)
      for (uint32_t i = 0; i < xs.count; ++i) {
        const double a = bilinear(l, xs.at[i], ys.at[j]);
        range = {std::min(range.low, a), std::max(range.high, a)};
      }
  }
  return {range.low - kFilter, range.high + kFilter};
}

Cover kept(const MaterialRecord& m, Interval sampled) {
  const double factor = m.base_colour.w, cutoff = m.alpha_cutoff;
  const double p = factor * sampled.low, q = factor * sampled.high;
  const double slack =
      sampled.low == sampled.high && sampled.low == 1 ? 0 : 2 * u * std::max(std::fabs(p), std::fabs(q));
  const double low = std::min(p, q) - slack, high = std::max(p, q) + slack;
  if (low >= cutoff) return Cover::in;
  if (high < cutoff) return Cover::out;
  return Cover::maybe;  // NaN too: GLSL leaves comparisons with it to the device
}

Cover kept_at(const Shape& s, const std::array<vec2, 3>& uv, const MaterialRecord& m, std::span<const Texture> textures,
              uint32_t sub_texel_bits, double x, double y) {
  const Attribute texcoord_u = attribute_at(s, {uv[0].x, uv[1].x, uv[2].x}, x, y);
  const Attribute texcoord_v = attribute_at(s, {uv[0].y, uv[1].y, uv[2].y}, x, y);
  return kept(m, sampled_alpha(m, textures, texcoord_u, texcoord_v, sub_texel_bits));
}

}  // namespace assay::raster
