#include "kernels/attribute_interpolation/codes.h"

#include <algorithm>
#include <cmath>

namespace assay::attribute_interpolation {

namespace {

constexpr double kMostUnorm = 65535, kMostSnorm = 32767;
constexpr double kLargestBelowTwo = 2 - 0x1p-10;  // binary16
constexpr double kLargestScaled = 65472;          // 9 bits of mantissa
constexpr int kLeastSharedExponent = -100;        // of the largest derivative; below, all are 0
constexpr int kMantissaBits = 12;

int sign_extended(uint bits) { return static_cast<int>(bits & 0x1fffu) - static_cast<int>((bits & 0x1000u) << 1); }

}  // namespace

double nearest_step(double v, double step) { return std::nearbyint(v / step) * step; }

double nearest_small_float(double v, int kept) {
  const int exponent = v == 0 ? -14 : std::max(std::ilogb(v), -14);
  return nearest_step(v, std::ldexp(1.0, exponent - kept));
}

double small_float(uint bits, int kept) {
  const uint mantissa = bits & ((1u << kept) - 1), exponent = bits >> kept & 31u;
  const double magnitude = exponent == 0 ? std::ldexp(mantissa, -14 - kept)
                                         : std::ldexp((1u << kept) + mantissa, static_cast<int>(exponent) - 15 - kept);
  return (bits >> (kept + 5) & 1u) != 0 ? -magnitude : magnitude;
}

BarycentricFields barycentric_fields(uint word, uint encoding) {
  const auto weight = [&](uint bits) {
    return static_cast<float>(encoding == kAttributesHalves ? small_float(bits, 10) : bits / kMostUnorm);
  };
  return {{weight(word & 0xffffu), weight(word >> 16)}, word == 0 ? 1.0f : 0.0f};
}

namespace {

DerivativeFields shared_exponent_fields(uvec2 words) {
  const int exponent = static_cast<int>(words.x >> 26 | (words.y >> 26 & 3u) << 6);
  const auto number = [&](uint bits) {
    return static_cast<float>(std::ldexp(sign_extended(bits), exponent - kAttributeExponentBias));
  };
  return {{number(words.x), number(words.x >> 13), number(words.y), number(words.y >> 13)},
          words.y >> 28 & 1u,
          words.y >> 29 & 1u,
          words.y >> 30 & 1u,
          words.y >> 31,
          0};
}

}  // namespace

DerivativeFields derivative_fields(uvec2 words, uint encoding) {
  DerivativeFields f;
  if (encoding == kAttributesPacked) {
    f = shared_exponent_fields(words);
  } else {
    const Few<uint, 4> halves = {words.x & 0xffffu, words.x >> 16, words.y & 0xffffu, words.y >> 16};
    uint flags[4];
    for (int k = 0; k < 4; ++k) {
      const bool scaled = encoding == kAttributesHalfScaled;
      flags[k] = scaled ? halves[k] & 1u : halves[k] >> 14 & 1u;
      f.derivatives[k] = static_cast<float>(scaled ? small_float(halves[k] >> 1, 9) / double{kAttributeHalfScale}
                                                   : small_float(halves[k] & 0xbfffu, 10));
    }
    f.front_facing = flags[0], f.normal_negative = flags[1], f.tangent_negative = flags[2], f.left_handed = flags[3];
  }
  f.blank = words == uvec2(0) ? 1.0f : 0.0f;
  return f;
}

FrameFields frame_fields(uvec2 words, uint encoding) {
  const auto number = [&](uint bits) {
    if (encoding == kAttributesHalves) return static_cast<float>(small_float(bits & 0xffffu, 10));
    return static_cast<float>(static_cast<int16_t>(bits & 0xffffu) / kMostSnorm);
  };
  return {{number(words.x), number(words.x >> 16)},
          {number(words.y), number(words.y >> 16)},
          words == uvec2(0) ? 1.0f : 0.0f};
}

namespace {

template <class Packed, class F>
Bytes unpacked(std::span<const std::byte> from, F fields) {
  using Fields = decltype(fields(Packed{}));
  const size_t count = from.size() / sizeof(Packed);
  Bytes to(count * sizeof(Fields));
  for (size_t i = 0; i < count; ++i) {
    Packed p;
    std::memcpy(&p, from.data() + i * sizeof p, sizeof p);
    const Fields f = fields(p);
    std::memcpy(to.data() + i * sizeof f, &f, sizeof f);
  }
  return to;
}

}  // namespace

Bytes unpack_barycentrics(std::span<const std::byte> from, uint encoding) {
  return unpacked<uint>(from, [=](uint word) { return barycentric_fields(word, encoding); });
}
Bytes unpack_derivatives(std::span<const std::byte> from, uint encoding) {
  return unpacked<uvec2>(from, [=](uvec2 words) { return derivative_fields(words, encoding); });
}
Bytes unpack_frame(std::span<const std::byte> from, uint encoding) {
  return unpacked<uvec2>(from, [=](uvec2 words) { return frame_fields(words, encoding); });
}

namespace {

// The nearest code of clamp(v, low, 1) * most, where the product rounds by u before it is rounded to a whole number.
double normalised(double v, double low, double most, double side) {
  const double steps = std::clamp(v, low, 1.0) * most;
  return std::nearbyint(steps + side * kUnitRoundoff * std::fabs(steps)) / most;
}

}  // namespace

Interval stored_weight(Interval v, uint encoding) {
  if (encoding == kAttributesHalves)
    return {nearest_small_float(std::clamp(v.low, 0.0, 1.0), 10),
            nearest_small_float(std::clamp(v.high, 0.0, 1.0), 10)};
  return {normalised(v.low, 0, kMostUnorm, -1), normalised(v.high, 0, kMostUnorm, 1)};
}

Interval stored_direction(Interval v, uint encoding) {
  if (encoding == kAttributesHalves) return {nearest_small_float(v.low, 10), nearest_small_float(v.high, 10)};
  return {normalised(v.low, -1, kMostSnorm, -1), normalised(v.high, -1, kMostSnorm, 1)};
}

namespace {

// The exponent is that of the largest of the four, which may be one of several: the hull over them.
Few<Interval, 4> stored_in_shared_exponent(const Few<Interval, 4>& d) {
  double least = 0, most = 0;  // of the largest magnitude
  for (const Interval& i : d) {
    const bool across = i.low <= 0 && i.high >= 0;
    least = std::max(least, across ? 0 : std::min(std::fabs(i.low), std::fabs(i.high)));
    most = std::max({most, std::fabs(i.low), std::fabs(i.high)});
  }
  const auto exponent = [](double v) {
    return v == 0 ? kLeastSharedExponent - 1 : std::clamp(std::ilogb(v), kLeastSharedExponent - 1, 127);
  };
  Few<Interval, 4> hull;
  for (Interval& i : hull) i = {HUGE_VAL, -HUGE_VAL};
  for (int e = exponent(least); e <= exponent(most); ++e) {
    const double step = std::ldexp(1.0, e + 1 - kMantissaBits), limit = kAttributeMantissaLimit * step;
    for (int k = 0; k < 4; ++k) {
      const Interval codes = e < kLeastSharedExponent
                                 ? Interval{0, 0}
                                 : Interval{std::clamp(nearest_step(d[k].low, step), -limit, limit),
                                            std::clamp(nearest_step(d[k].high, step), -limit, limit)};
      hull[k] = {std::min(hull[k].low, codes.low), std::max(hull[k].high, codes.high)};
    }
  }
  return hull;
}

}  // namespace

Few<Interval, 4> stored_derivatives(const Few<Interval, 4>& d, uint encoding) {
  if (encoding == kAttributesPacked) return stored_in_shared_exponent(d);
  Few<Interval, 4> stored;
  for (int k = 0; k < 4; ++k) {
    const auto one = [&](double v) {
      if (encoding == kAttributesHalves)
        return nearest_small_float(std::clamp(v, -kLargestBelowTwo, kLargestBelowTwo), 10);
      return nearest_small_float(std::clamp(v * double{kAttributeHalfScale}, -kLargestScaled, kLargestScaled), 9) /
             double{kAttributeHalfScale};
    };
    stored[k] = {one(d[k].low), one(d[k].high)};
  }
  return stored;
}

glm::dvec3 direction_of(const vec2& stored, bool negative, uint encoding) {
  const double x = stored.x, y = stored.y, r = x * x + y * y;
  const double side = negative ? -1 : 1;
  if (encoding == kAttributesHalves) {
    const double z = std::sqrt(std::max(1 - r, 0.0)), length = std::sqrt(r + z * z);
    return {x / length, y / length, side * z / length};
  }
  const double inside = std::min(r, 1.0), spread = std::sqrt(2 - inside);
  return {x * spread, y * spread, side * (1 - inside)};
}

}  // namespace assay::attribute_interpolation
