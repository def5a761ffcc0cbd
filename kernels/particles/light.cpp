#include "kernels/particles/light.h"

#include <algorithm>
#include <cmath>

#include "harness/half.h"
#include "harness/lighting_oracle.h"
#include "harness/radiance_oracle.h"

namespace assay::particles {

using glm::dvec3;

namespace {

struct Rect {
  int64_t x = 0, y = 0, side = 0;
};
Rect rect_of(const Atlas& atlas, uint32_t word) {
  const uint32_t size = word >> kRectSizeShift & 3u;
  if (size == 0) return {};
  const Rect r = {(word & kRectXBits) * int64_t{8}, (word >> kRectYShift & kRectXBits) * int64_t{8},
                  int64_t{4} << size};
  return r.x + r.side <= atlas.side && r.y + r.side <= atlas.side ? r : Rect{};
}

constexpr double kAny = 1e300;  // light of what is no number: whatever a device makes of it, up to here

// Infinities and NaN are NaN.
dvec3 decoded(const Atlas& atlas, size_t at) {
  if (atlas.encoding == kLightRgba16) {
    const uint32_t low = atlas.words[2 * at], high = atlas.words[2 * at + 1];
    const auto half = [](uint32_t bits) { return half_value(static_cast<uint16_t>(bits)); };
    const dvec3 halves = {half(low), half(low >> 16), half(high)};
    return halves + (halves - halves);
  }
  const uint32_t word = atlas.words[at];
  dvec3 v = radiance::decoded({word, 0}, atlas.encoding);
  if (atlas.encoding == kLightR11G11B10)
    for (int i = 0; i < 3; ++i)
      if (const uint32_t exponent = i < 2 ? 0x7c0u << 11 * i : 0xf8000000u; (word & exponent) == exponent) v[i] = NAN;
  return v;
}
dvec3 texel(const Atlas& atlas, const Rect& r, int64_t x, int64_t y) {
  const int64_t column = r.x + std::clamp<int64_t>(x, 0, r.side - 1), row = r.y + std::clamp<int64_t>(y, 0, r.side - 1);
  return decoded(atlas, static_cast<size_t>(row * atlas.side + column));
}

// Weights of the texels from one before the place to two after it, of its fraction f between two.
std::array<Interval, 4> weights(Filter filter, Interval f) {
  const Interval one = exactly(1), g = one - f;
  switch (filter) {
    case Filter::bilinear:
      return {exactly(0), g, f, exactly(0)};
    case Filter::b_spline: {
      const auto inner = [&](Interval a, Interval b) {
        return (exactly(4) - exactly(3) * a * a * (one + b)) / exactly(6);
      };
      return {g * g * g / exactly(6), inner(f, g), inner(g, f), f * f * f / exactly(6)};
    }
    case Filter::catmull_rom:
      break;
  }
  const Interval half = exactly(0.5);
  return {f * (f * (one - half * f) - half), one + f * f * (exactly(1.5) * f - exactly(2.5)),
          f * (half + f * (exactly(2) - exactly(1.5) * f)), f * f * (half * f - half)};
}

// Between texel `first` and the next, either way. A product of weights and a texel is rounded twice, the sum of 16 at
// most 16 times: 18 u of the terms' magnitudes.
Colour in_cell(const Atlas& atlas, const Rect& r, Filter filter, glm::i64vec2 first, Interval fx, Interval fy) {
  const auto x = weights(filter, fx), y = weights(filter, fy);
  Colour sum = {};
  dvec3 size(0), least(kAny), most(0);
  for (size_t j = 0; j < 4; ++j)
    for (size_t i = 0; i < 4; ++i) {
      if (filter == Filter::bilinear && (i % 3 == 0 || j % 3 == 0)) continue;
      const dvec3 t = texel(atlas, r, first.x + static_cast<int64_t>(i) - 1, first.y + static_cast<int64_t>(j) - 1);
      const auto [low, high] =
          std::minmax({x[i].low * y[j].low, x[i].low * y[j].high, x[i].high * y[j].low, x[i].high * y[j].high});
      for (int c = 0; c < 3; ++c) {
        sum[static_cast<size_t>(c)].low += std::min(low * t[c], high * t[c]);
        sum[static_cast<size_t>(c)].high += std::max(low * t[c], high * t[c]);
        size[c] += std::max(std::fabs(low), std::fabs(high)) * std::fabs(t[c]);
      }
      if (i % 3 != 0 && j % 3 != 0) least = min(least, t), most = max(most, t);
    }
  for (int c = 0; c < 3; ++c) {
    Interval& s = sum[static_cast<size_t>(c)];
    const double error = 18 * kUnitRoundoff * bounded::kSlack * size[c];
    s = {s.low - error, s.high + error};
    if (filter == Filter::catmull_rom) s = clamped(s, least[c], most[c]);
    if (std::isnan(size[c])) s = {-kAny, kAny};
  }
  return sum;
}

Colour any_texel(const Atlas& atlas, const Rect& r) {
  dvec3 least(kAny), most(0), sum(0);
  for (int64_t y = 0; y < r.side; ++y)
    for (int64_t x = 0; x < r.side; ++x) {
      const dvec3 t = texel(atlas, r, x, y);
      least = min(least, t), most = max(most, t), sum += t;
    }
  Colour any;
  for (int c = 0; c < 3; ++c)
    any[static_cast<size_t>(c)] =
        std::isnan(sum[c]) ? Interval{-kAny, kAny} : bounded::rounded({least[c], most[c]}, 24);
  return any;
}

// Of texels counted from the first one's centre.
Interval in_texels(const Rect& r, Interval at) {
  const Interval inside = clamped(at, -1, 1);  // elsewhere nothing is drawn
  return (inside * exactly(0.5) + exactly(0.5)) * exactly(static_cast<double>(r.side)) - exactly(0.5);
}

}  // namespace

std::optional<Colour> from_atlas(const Atlas& atlas, uint32_t word, Filter filter, const Place& place) {
  const Rect r = rect_of(atlas, word);
  if (r.side == 0) return {};
  if (!place.known) return any_texel(atlas, r);
  const Interval x = in_texels(r, place.x), y = in_texels(r, place.y);
  const auto first_x = static_cast<int64_t>(std::floor(x.low)), last_x = static_cast<int64_t>(std::floor(x.high)),
             first_y = static_cast<int64_t>(std::floor(y.low)), last_y = static_cast<int64_t>(std::floor(y.high));
  if (last_x - first_x > 2 || last_y - first_y > 2) return any_texel(atlas, r);
  std::optional<Colour> all;
  for (int64_t j = first_y; j <= last_y; ++j)
    for (int64_t i = first_x; i <= last_x; ++i) {
      const auto fraction = [](Interval v, int64_t from) {
        return clamped(v - exactly(static_cast<double>(from)), 0, 1);
      };
      const Colour here = in_cell(atlas, r, filter, {i, j}, fraction(x, i), fraction(y, j));
      for (size_t c = 0; c < 3 && all; ++c) (*all)[c] = hull((*all)[c], here[c]);
      if (!all) all = here;
    }
  return all;
}

Colour lit(const ParticleRecord& p, const Ball& position, const vec3& ambient, std::span<const LightRecord> lights) {
  const Ball normal =
      normalised(cross(normalised({dvec3(p.right), 0}, kShortestVector), normalised({dvec3(p.up), 0}, kShortestVector)),
                 kShortestVector);
  const Interval facing = dot(normal, {dvec3(p.centre), 0});
  shading::OracleSurface s;
  s.position = position;
  s.to_eye = -normalised(position, kShortestVector);
  s.base_colour = {exactly(1), exactly(1), exactly(1)};
  s.metallic = exactly(0), s.roughness = exactly(1);
  s.features = kFeatureSubsurface;
  const auto sum = [&](const Ball& towards_eye) {
    s.normal = towards_eye;
    Colour all = shading::shade_ambient(s, ambient);
    for (const LightRecord& light : lights) all = all + shading::shade(s, light);
    return all;
  };
  if (facing.low > 0) return sum(-normal);
  Colour front = sum(normal);
  if (facing.high <= 0) return front;
  const Colour back = sum(-normal);
  for (size_t c = 0; c < 3; ++c) front[c] = hull(front[c], back[c]);
  return front;
}

Colour from_corners(const std::array<Colour, 4>& corners, const Place& place) {
  const auto share = [](Interval at) { return clamped(clamped(at, -1, 1) * exactly(0.5) + exactly(0.5), 0, 1); };
  const Interval x = place.known ? share(place.x) : Interval{0, 1}, y = place.known ? share(place.y) : Interval{0, 1};
  const Interval far = {std::min(x.low, y.low), std::min(x.high, y.high)},
                 near = {std::max(x.low, y.low), std::max(x.high, y.high)};
  const auto over = [&](const Colour& third) {
    return corners[0] * (exactly(1) - near) + third * at_least(near - far, 0) + corners[2] * far;
  };
  if (x.low > y.high) return over(corners[1]);
  Colour upper = over(corners[3]);
  if (y.low > x.high) return upper;
  const Colour lower = over(corners[1]);
  for (size_t c = 0; c < 3; ++c) upper[c] = hull(upper[c], lower[c]);
  return upper;
}

}  // namespace assay::particles
