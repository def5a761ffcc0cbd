#include "tests/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assay::tests {
namespace {

using glm::dvec2;

constexpr double kMostTexels = 8;  // of a box that is searched; a wider one has the range of what it covers, by strides

// Where a bilinear function over a box has its extremes in one direction: the ends, and the texel centres between.
std::vector<double> knots(double low, double high) {
  std::vector<double> at = {low, high};
  for (double k = std::ceil(low); k <= high; ++k) at.push_back(k);
  return at;
}

// Share of the coarse texel's width that each fine texel it touches covers.
double overlap(uint32_t fine, uint32_t coarse, uint32_t i, uint32_t t) {
  const double step = static_cast<double>(fine) / coarse;
  return std::max(0.0, std::min(t + 1.0, (i + 1) * step) - std::max<double>(t, i * step)) / step;
}

}  // namespace

Range operator*(const Range& a, const Range& b) {
  const double all[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return {*std::min_element(all, all + 4), *std::max_element(all, all + 4)};
}
Range operator*(double a, const Range& b) { return Range{a, a} * b; }
Range hull(const Range& a, const Range& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
Range mix(const Range& a, const Range& b, double t) {
  return {a.low + (b.low - a.low) * t, a.high + (b.high - a.high) * t};
}

double srgb_to_linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }
double linear_to_srgb(double l) { return l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(l, 1 / 2.4) - 0.055; }

Range level_of_detail(const Footprint& f, uint32_t width, uint32_t height, const SamplerRoom& room) {
  const dvec2 size(width, height);
  double low = 0, high = 0;
  for (const dvec2& per : {f.per_x, f.per_y}) {
    const dvec2 least = max(abs(per) - f.gradient_error, dvec2(0)) * size, most = (abs(per) + f.gradient_error) * size;
    low = std::max(low, std::max(least.x, least.y));
    high = std::max(high, std::sqrt(2.0) * (most.x + most.y));
  }
  const auto log = [](double rho) { return rho > 0 ? std::log2(rho) : -100.0; };
  return Range{log(low), log(high)}.widened(room.level);
}

uint32_t Filter::levels(uint32_t image) const {
  uint32_t n = 1;
  for (uint32_t side = std::max(scene_.images[image].width, scene_.images[image].height); side > 1; side /= 2) ++n;
  return n;
}

double Filter::value(uint32_t image, bool srgb, const Level& l, uint32_t x, uint32_t y, uint32_t channel) const {
  static const std::array<double, 256> decoded = [] {
    std::array<double, 256> table = {};
    for (size_t i = 0; i < 256; ++i) table[i] = srgb_to_linear(static_cast<double>(i) / 255);
    return table;
  }();
  const size_t at = (size_t{y} * l.width + x) * 4 + channel;
  if (!l.linear.empty()) return double{l.linear[at]};
  const uint8_t code = scene_.images[image].rgba[at];
  return srgb && channel != 3 ? decoded[code] : code / 255.0;
}

const Filter::Level& Filter::level(uint32_t image, bool srgb, uint32_t index) {
  std::vector<Level>& chain = chains_[{image, srgb}];
  while (chain.size() <= index) {
    const scene::Image& source = scene_.images[image];
    Level next;
    if (chain.empty()) {
      next = {source.width, source.height, {}};
    } else {
      const Level& fine = chain.back();
      next = {std::max(1u, fine.width / 2), std::max(1u, fine.height / 2), {}};
      for (uint32_t y = 0; y < next.height; ++y)
        for (uint32_t x = 0; x < next.width; ++x)
          for (uint32_t c = 0; c < 4; ++c) {
            double sum = 0;
            for (uint32_t j = y * 2; j < std::min(fine.height, y * 2 + 3); ++j)
              for (uint32_t i = x * 2; i < std::min(fine.width, x * 2 + 3); ++i)
                sum += overlap(fine.height, next.height, y, j) * overlap(fine.width, next.width, x, i) *
                       value(image, srgb, fine, i, j, c);
            next.linear.push_back(static_cast<float>(sum));
          }
    }
    chain.push_back(std::move(next));
  }
  return chain[index];
}

RangedTexel Filter::texel(uint32_t image, bool srgb, uint32_t index, int64_t x, int64_t y) {
  const Level& l = level(image, srgb, index);
  const auto wrap = [](int64_t i, uint32_t n) { return static_cast<uint32_t>((i % n + n) % n); };
  RangedTexel t;
  for (uint32_t c = 0; c < 4; ++c) {
    const double mean = value(image, srgb, l, wrap(x, l.width), wrap(y, l.height), c);
    const bool curved = srgb && c != 3;
    // Levels below the first are rounded to the nearest code from a mean in floats.
    const double stored = index > 0 ? 0.5 / 255 + 1e-5 : 1e-7, room = stored + (curved ? room_.texel_srgb : 0);
    const double at = curved ? linear_to_srgb(mean) : mean;
    t[c] = Range{at - room, at + room};
    if (curved) t[c] = {srgb_to_linear(std::max(0.0, t[c].low)), srgb_to_linear(t[c].high)};
  }
  return t;
}

RangedTexel Filter::sample_level(uint32_t image, bool srgb, uint32_t index, const Footprint& f) {
  const Level& l = level(image, srgb, index);
  const dvec2 size(l.width, l.height), centre = f.uv * size - 0.5;
  // Three roundings of a float coordinate, and a step of the weights.
  const dvec2 reach = f.uv_error * size + (abs(f.uv) * size + 1.0) * 3.0 * std::ldexp(1.0, -24) + room_.weight;
  RangedTexel out;
  out.fill({std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  const auto add = [&](const RangedTexel& t) {
    for (size_t c = 0; c < 4; ++c) out[c] = hull(out[c], t[c]);
  };
  if (std::max(reach.x, reach.y) * 2 > kMostTexels) {  // all of the level, seen once
    for (int64_t y = 0; y < l.height; ++y)
      for (int64_t x = 0; x < l.width; ++x) add(texel(image, srgb, index, x, y));
    return out;
  }
  for (const double y : knots(centre.y - reach.y, centre.y + reach.y))
    for (const double x : knots(centre.x - reach.x, centre.x + reach.x)) {
      const auto i = static_cast<int64_t>(std::floor(x)), j = static_cast<int64_t>(std::floor(y));
      const double u = x - std::floor(x), v = y - std::floor(y);
      const RangedTexel a = texel(image, srgb, index, i, j), b = texel(image, srgb, index, i + 1, j),
                        d = texel(image, srgb, index, i, j + 1), e = texel(image, srgb, index, i + 1, j + 1);
      RangedTexel t;
      for (size_t c = 0; c < 4; ++c) t[c] = mix(mix(a[c], b[c], u), mix(d[c], e[c], u), v);
      add(t);
    }
  return out;
}

RangedTexel Filter::sample(uint32_t image, bool srgb, const Footprint& f) {
  RangedTexel out;
  out.fill({1, 1});
  if (image == scene::kNone) return out;
  const scene::Image& source = scene_.images[image];
  const double last = levels(image) - 1;
  const Range lambda = level_of_detail(f, source.width, source.height, room_);
  const double low = std::clamp(lambda.low, 0.0, last), high = std::clamp(lambda.high, 0.0, last);
  bool first = true;
  for (const double at : knots(low, high)) {
    const auto fine = static_cast<uint32_t>(at);
    RangedTexel t = sample_level(image, srgb, fine, f);
    if (at > fine) {
      const RangedTexel coarse = sample_level(image, srgb, fine + 1, f);
      for (size_t c = 0; c < 4; ++c) t[c] = mix(t[c], coarse[c], at - fine);
    }
    for (size_t c = 0; c < 4; ++c) out[c] = first ? t[c] : hull(out[c], t[c]);
    first = false;
  }
  for (size_t c = 0; c < 4; ++c) {
    out[c] = out[c].widened(srgb && c != 3 ? room_.value_srgb : room_.value);
    out[c] = {std::max(0.0, out[c].low), std::min(1.0, out[c].high)};
  }
  return out;
}

}  // namespace assay::tests
