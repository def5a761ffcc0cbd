#include "harness/image/flip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <stdexcept>

#include "harness/parallel.h"

namespace assay::image {

namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
constexpr double kPi = 3.14159265358979323846;

struct Plane {
  uint32_t width = 0, height = 0;
  std::vector<double> of;
  Plane(uint32_t w, uint32_t h) : width(w), height(h), of(size_t{w} * h) {}
};

template <class Of>
void each_row(uint32_t height, const Of& of) {
  in_parallel(height, [&](uint64_t y) { of(static_cast<uint32_t>(y)); });
}

// ---- Colours

const dmat3 kXyzOfRgb = glm::transpose(dmat3(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
                                             2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
                                             1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
const dmat3 kRgbOfXyz = glm::inverse(kXyzOfRgb);
const dvec3 kWhite = kXyzOfRgb * dvec3(1);

// Y, Cx, Cz: linear in light, so that they can be filtered.
dvec3 opponent_of(const dvec3& rgb) {
  const dvec3 v = kXyzOfRgb * rgb / kWhite;
  return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}
dvec3 rgb_of_opponent(const dvec3& c) {
  const double y = (c.x + 16) / 116;
  return kRgbOfXyz * (dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

double lab_curve(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}
// L*a*b* with chroma that fades with lightness, after Hunt.
dvec3 hunt_lab_of(const dvec3& rgb) {
  const dvec3 v = kXyzOfRgb * rgb / kWhite;
  const double x = lab_curve(v.x), y = lab_curve(v.y), z = lab_curve(v.z), lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}
double hyab(const dvec3& a, const dvec3& b) { return std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

constexpr double kColourExponent = 0.7, kKnee = 0.4, kKneeAt = 0.95;
const double kMostColour = std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), kColourExponent);

double colour_error(const dvec3& reference, const dvec3& test) {
  const double off = std::pow(hyab(hunt_lab_of(reference), hunt_lab_of(test)), kColourExponent);
  const double knee = kKnee * kMostColour;
  if (off < knee) return off * kKneeAt / knee;
  return kKneeAt + (off - knee) / (kMostColour - knee) * (1 - kKneeAt);
}

// ---- Filters: rows, then columns; beyond the sides the outermost pixels go on

using Weights = std::vector<double>;  // 2 radius + 1

template <class Of>
Weights weights(int radius, const Of& of) {
  Weights w;
  for (int i = -radius; i <= radius; ++i) w.push_back(of(static_cast<double>(i)));
  return w;
}

Plane filtered(const Plane& in, const Weights& across, const Weights& down) {
  Plane half(in.width, in.height), out(in.width, in.height);
  const auto pass = [](const double* from, double* to, size_t stride, uint32_t count, const Weights& w) {
    const auto radius = static_cast<int64_t>(w.size() / 2), last = int64_t{count} - 1;
    for (int64_t i = 0; i <= last; ++i) {
      double sum = 0;
      for (int64_t k = -radius; k <= radius; ++k)
        sum += w[static_cast<size_t>(k + radius)] *
               from[static_cast<size_t>(std::clamp(i + k, int64_t{0}, last)) * stride];
      to[static_cast<size_t>(i) * stride] = sum;
    }
  };
  each_row(in.height, [&](uint32_t y) {
    pass(&in.of[size_t{y} * in.width], &half.of[size_t{y} * in.width], 1, in.width, across);
  });
  each_row(in.width, [&](uint32_t x) { pass(&half.of[x], &out.of[x], in.width, in.height, down); });
  return out;
}

// What the eye makes of contrast, a channel: a sum of two Gaussians in degrees, given as weights a and widths b.
struct Contrast {
  dvec2 a, b;
};
constexpr Contrast kContrast[3] = {{{1, 0}, {0.0047, 1e-5}}, {{1, 0}, {0.0053, 1e-5}}, {{34.1, 13.5}, {0.04, 0.025}}};

Plane as_seen(const Plane& in, const Contrast& contrast, double pixels_a_degree) {
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * pixels_a_degree));
  Weights lines[2];
  double sums[2] = {}, total = 0;
  for (int k = 0; k < 2; ++k) {
    lines[k] = weights(radius, [&](double i) {
      const double x = i / pixels_a_degree;
      return std::exp(-kPi * kPi * x * x / contrast.b[k]);
    });
    double sum = 0;
    for (const double w : lines[k]) sum += w;
    for (double& w : lines[k]) w /= sum;
    sums[k] = contrast.a[k] * std::sqrt(kPi / contrast.b[k]) * sum * sum;
    total += sums[k];
  }
  Plane out(in.width, in.height);
  for (int k = 0; k < 2; ++k) {
    if (sums[k] == 0) continue;
    const Plane part = filtered(in, lines[k], lines[k]);
    for (size_t i = 0; i < out.of.size(); ++i) out.of[i] += sums[k] / total * part.of[i];
  }
  return out;
}

// Weights below 0 add up to -1, those above to 1.
void normalise(Weights& w) {
  double below = 0, above = 0;
  for (const double x : w) (x < 0 ? below : above) += std::fabs(x);
  for (double& x : w) x /= x < 0 ? below : above;
}

struct Features {
  std::vector<double> edges, points;
};
Features features_of(const Plane& lightness, double pixels_a_degree) {
  const double deviation = 0.5 * 0.082 * pixels_a_degree, square = deviation * deviation;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto bell = [&](double x) { return std::exp(-x * x / (2 * square)); };
  Weights smooth = weights(radius, bell), slope = weights(radius, [&](double x) { return -x * bell(x); }),
          bend = weights(radius, [&](double x) { return (x * x / square - 1) * bell(x); });
  normalise(smooth), normalise(slope), normalise(bend);
  const auto lengths = [](const Plane& x, const Plane& y) {
    std::vector<double> all(x.of.size());
    for (size_t i = 0; i < all.size(); ++i) all[i] = std::hypot(x.of[i], y.of[i]);
    return all;
  };
  return {lengths(filtered(lightness, slope, smooth), filtered(lightness, smooth, slope)),
          lengths(filtered(lightness, bend, smooth), filtered(lightness, smooth, bend))};
}

// ---- One picture beside the other

struct Seen {
  std::vector<dvec3> colours;  // filtered, linear, in 0..1
  Features features;
};

Seen seen(const Pixels& p, double pixels_a_degree) {
  Plane channels[3] = {{p.width, p.height}, {p.width, p.height}, {p.width, p.height}};
  Plane lightness(p.width, p.height);
  for (size_t i = 0; i < p.rgb.size(); ++i) {
    const dvec3 c = opponent_of(glm::clamp(dvec3(p.rgb[i]), 0.0, 1.0));
    for (int k = 0; k < 3; ++k) channels[k].of[i] = c[k];
    lightness.of[i] = (c.x + 16) / 116;
  }
  Seen s = {std::vector<dvec3>(p.rgb.size()), features_of(lightness, pixels_a_degree)};
  for (int k = 0; k < 3; ++k) channels[k] = as_seen(channels[k], kContrast[k], pixels_a_degree);
  for (size_t i = 0; i < s.colours.size(); ++i)
    s.colours[i] = glm::clamp(rgb_of_opponent({channels[0].of[i], channels[1].of[i], channels[2].of[i]}), 0.0, 1.0);
  return s;
}

void must_compare(const Pixels& a, const Pixels& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::runtime_error(
        fmt::format("pictures of {}x{} and {}x{} cannot be compared", a.width, a.height, b.width, b.height));
  for (const Pixels* p : {&a, &b})
    for (size_t i = 0; i < p->rgb.size(); ++i)
      for (int k = 0; k < 3; ++k)
        if (!std::isfinite(p->rgb[i][k]))
          throw std::runtime_error(fmt::format("the {} holds {} at pixel ({}, {}), which no error can be told of",
                                               p == &a ? "reference" : "other picture", p->rgb[i][k], i % p->width,
                                               i / p->width));
}

std::vector<float> error_map(const Pixels& reference, const Pixels& test, double pixels_a_degree) {
  const Seen r = seen(reference, pixels_a_degree), t = seen(test, pixels_a_degree);
  std::vector<float> map(r.colours.size());
  each_row(reference.height, [&](uint32_t y) {
    for (size_t i = size_t{y} * reference.width; i < size_t{y + 1} * reference.width; ++i) {
      const double edge = std::fabs(r.features.edges[i] - t.features.edges[i]),
                   point = std::fabs(r.features.points[i] - t.features.points[i]),
                   feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0));
      map[i] = static_cast<float>(std::pow(colour_error(r.colours[i], t.colours[i]), 1 - feature));
    }
  });
  return map;
}

double mean_of(const std::vector<float>& map) {
  double sum = 0;
  for (const float v : map) sum += v;
  return sum / static_cast<double>(map.size());
}

// ---- Radiance

// A fit of ACES' curve: (a x + b) x / ((c x + d) x + e), its input scaled by 0.6 (Narkowicz 2015).
constexpr double kA = 0.36 * 2.51, kB = 0.6 * 0.03, kC = 0.36 * 2.43, kD = 0.6 * 0.59, kE = 0.14;
double toned(double x) { return std::clamp((kA * x + kB) * x / ((kC * x + kD) * x + kE), 0.0, 1.0); }

// Where the curve is 0.85: brighter says nothing more.
double bright_end() {
  constexpr double kAt = 0.85, a = kA - kAt * kC, b = kB - kAt * kD, c = -kAt * kE;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

Pixels exposed(const Pixels& p, double stops) {
  Pixels out = p;
  const double gain = std::exp2(stops);
  for (glm::vec3& c : out.rgb)
    for (int k = 0; k < 3; ++k) c[k] = static_cast<float>(toned(std::max(0.0f, c[k]) * gain));
  return out;
}

double luminance(const glm::vec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

void choose_exposures(const Pixels& reference, Flip& to) {
  std::vector<double> all;
  all.reserve(reference.rgb.size());
  for (const glm::vec3& c : reference.rgb) all.push_back(luminance(c));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  constexpr double kLeast = std::numeric_limits<float>::epsilon();
  const double median = std::max(*middle, kLeast), most = std::max(*std::max_element(middle, all.end()), kLeast);
  to.start = std::log2(bright_end() / most), to.stop = std::log2(bright_end() / median);
  to.exposures = static_cast<uint32_t>(std::max(2.0, std::ceil(to.stop - to.start)));
}

double decibels(double mean_square, double peak) {
  return mean_square == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(peak * peak / mean_square);
}

}  // namespace

Pixels linear_of(const Rgba8& p) {
  Pixels out = {p.width, p.height, std::vector<glm::vec3>(size_t{p.width} * p.height)};
  const auto linear = [](uint8_t code) {
    const double v = code / 255.0;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  };
  for (size_t i = 0; i < out.rgb.size(); ++i)
    out.rgb[i] = {linear(p.texels[4 * i]), linear(p.texels[4 * i + 1]), linear(p.texels[4 * i + 2])};
  return out;
}

Pixels linear_of(const Layers& layers) {
  const auto find = [&](const std::string& name) -> const Channel* {
    const auto it = std::ranges::find(layers.channels, name, &Channel::name);
    return it == layers.channels.end() || it->sample == Sample::uint32 ? nullptr : &*it;
  };
  for (const std::string prefix : {"", "radiance."}) {
    const Channel *r = find(prefix + "R"), *g = find(prefix + "G"), *b = find(prefix + "B");
    if (!r || !g || !b) continue;
    Pixels out = {layers.width, layers.height, {}};
    for (size_t i = 0; i < r->values.size(); ++i) out.rgb.emplace_back(r->values[i], g->values[i], b->values[i]);
    return out;
  }
  throw std::runtime_error("has no channels R, G and B, nor radiance.R, radiance.G and radiance.B, of numbers");
}

Flip flip(const Pixels& reference, const Pixels& test, double pixels_a_degree) {
  must_compare(reference, test);
  Flip f{.map = error_map(reference, test, pixels_a_degree)};
  f.mean = mean_of(f.map);
  return f;
}

Flip flip_hdr(const Pixels& reference, const Pixels& test, double pixels_a_degree) {
  must_compare(reference, test);
  Flip f{.map = std::vector<float>(reference.rgb.size())};
  choose_exposures(reference, f);
  for (uint32_t i = 0; i < f.exposures; ++i) {
    const double stops = f.start + (f.stop - f.start) * i / (f.exposures - 1);
    const auto map = error_map(exposed(reference, stops), exposed(test, stops), pixels_a_degree);
    for (size_t p = 0; p < map.size(); ++p) f.map[p] = std::max(f.map[p], map[p]);
  }
  f.mean = mean_of(f.map);
  return f;
}

double psnr(const Rgba8& reference, const Rgba8& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::runtime_error("pictures of two sizes cannot be compared");
  double sum = 0;
  for (size_t i = 0; i < reference.texels.size(); ++i)
    if (i % 4 != 3) sum += std::pow(int{reference.texels[i]} - int{test.texels[i]}, 2);
  return decibels(sum / (static_cast<double>(reference.texels.size()) * 0.75), 255);
}

double psnr(const Pixels& reference, const Pixels& test) {
  must_compare(reference, test);
  double sum = 0, peak = 0;
  for (size_t i = 0; i < reference.rgb.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      sum += std::pow(double{reference.rgb[i][k]} - test.rgb[i][k], 2);
      peak = std::max(peak, double{reference.rgb[i][k]});
    }
  return decibels(sum / (3.0 * static_cast<double>(reference.rgb.size())), peak);
}

}  // namespace assay::image
