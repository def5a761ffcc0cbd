#include "kernels/attribute_interpolation/classes.h"

#include <cmath>
#include <limits>

namespace assay::attribute_interpolation {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kPi = 3.14159265358979323846;
constexpr double kFree = std::numeric_limits<double>::infinity();

double log_range(Pcg32& rng, double low, double high) { return low * std::pow(high / low, rng.unit()); }
double either_sign(Pcg32& rng, double v) { return rng.below(2) == 0 ? v : -v; }

// Uniform in the simplex.
dvec3 weights(Pcg32& rng) {
  const double a = std::sqrt(rng.unit()), b = rng.unit();
  return {1 - a, a * (1 - b), a * b};
}

// Clip coordinates of a framebuffer position at distance w.
dvec3 clip_at(const dvec2& position, double w, uvec2 viewport) {
  return {(2 * position.x / viewport.x - 1) * w, (2 * position.y / viewport.y - 1) * w, w};
}
dvec2 centre(uvec2 pixel) { return {pixel.x + 0.5, pixel.y + 0.5}; }

ClipSample sample_of(const std::array<dvec3, 3>& v, uvec2 pixel, uvec2 viewport) {
  return {vec3(v[0]), vec3(v[1]), vec3(v[2]), pixel, viewport};
}

// Three framebuffer positions around the pixel's centre: a triangle that fits a disc of this diameter and fills an
// eighth of it or more, moved so that the centre is anywhere inside.
std::array<dvec2, 3> fat_triangle(Pcg32& rng, uvec2 pixel, double diameter) {
  std::array<dvec2, 3> p;
  double area = 0;
  do {
    for (dvec2& v : p) {
      const double angle = rng.range(0, 2 * kPi), r = 0.5 * diameter * std::sqrt(rng.unit());
      v = {r * std::cos(angle), r * std::sin(angle)};
    }
    area = std::fabs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y)) / 2;
  } while (area < 0.1 * diameter * diameter);
  const dvec3 inside = weights(rng);
  const dvec2 at = inside.x * p[0] + inside.y * p[1] + inside.z * p[2];
  for (dvec2& v : p) v += centre(pixel) - at;
  return p;
}

// Distances within `spread` of a distance between one and a hundred.
ClipSample placed(Pcg32& rng, const std::array<dvec2, 3>& p, double spread, uvec2 pixel, uvec2 viewport) {
  const double w = log_range(rng, 1, 100);
  std::array<dvec3, 3> v;
  for (size_t k = 0; k < 3; ++k) v[k] = clip_at(p[k], w * rng.range(1 - spread, 1 + spread), viewport);
  return sample_of(v, pixel, viewport);
}

template <int low_thousandths, int high_thousandths, int spread_percent = 10>
ClipSample fat(Pcg32& rng, uvec2 pixel, uvec2 viewport) {
  const double diameter = log_range(rng, low_thousandths / 1000.0, high_thousandths / 1000.0);
  return placed(rng, fat_triangle(rng, pixel, diameter), spread_percent / 100.0, pixel, viewport);
}

// A base through the pixel's centre, the third vertex at the height that gives the area.
template <int exponent>
ClipSample sliver(Pcg32& rng, uvec2 pixel, uvec2 viewport) {
  const double area = std::pow(10.0, exponent), base = log_range(rng, 1, 100), angle = rng.range(0, 2 * kPi);
  const dvec2 along = {std::cos(angle), std::sin(angle)}, up = {-along.y, along.x};
  const double t = rng.unit(), height = 2 * area / base, at = rng.range(-0.5, 0.5);
  const dvec2 on_base = -t * base * along;
  const std::array<dvec2, 3> p = {centre(pixel) + on_base, centre(pixel) + on_base + base * along,
                                  centre(pixel) + at * base * along + height * up};
  return placed(rng, p, 0.1, pixel, viewport);
}
template <int exponent>
ClipSample central_sliver(Pcg32& rng, uvec2, uvec2 viewport) {
  const uvec2 pixel = viewport / 2u - 2u + uvec2(rng.below(4), rng.below(4));
  return sliver<exponent>(rng, pixel, viewport);
}

// Two vertices anywhere, and the third where it has to be for the eye to hit the triangle at the pixel at distance w.
std::array<dvec3, 3> hit_at(Pcg32& rng, uvec2 pixel, uvec2 viewport, double w, double reach) {
  const dvec3 hit = clip_at(centre(pixel), w, viewport);
  const auto anywhere = [&] {
    return dvec3(rng.range(-reach, reach), rng.range(-reach, reach), rng.range(-reach, reach));
  };
  std::array<dvec3, 3> v = {dvec3(0), anywhere(), anywhere()};
  dvec3 l;
  do {
    l = weights(rng);
  } while (l.x < 0.05);
  v[0] = (hit - l.y * v[1] - l.z * v[2]) / l.x;
  return v;
}
// How steeply the pixel's ray meets the plane: sine of the angle.
double steepness(const std::array<dvec3, 3>& v, uvec2 pixel, uvec2 viewport) {
  const dvec3 n = cross(v[1] - v[0], v[2] - v[0]), ray = clip_at(centre(pixel), 1, viewport);
  return std::fabs(dot(n, ray)) / (length(n) * length(ray));
}

// One or two vertices behind the eye.
ClipSample crossing(Pcg32& rng, uvec2 pixel, uvec2 viewport) {
  std::array<dvec3, 3> v;
  int behind = 0;
  do {
    v = hit_at(rng, pixel, viewport, log_range(rng, 0.5, 5), 10);
    behind = (v[0].z < 0) + (v[1].z < 0) + (v[2].z < 0);
  } while (behind == 0 || behind == 3 || steepness(v, pixel, viewport) < 0.2);
  return sample_of(v, pixel, viewport);
}

// A vertex in the plane of the eye, or almost.
ClipSample tiny_w(Pcg32& rng, uvec2 pixel, uvec2 viewport) {
  std::array<dvec3, 3> v;
  const dvec3 hit = clip_at(centre(pixel), log_range(rng, 0.5, 5), viewport);
  do {
    dvec3 l;
    do {
      l = weights(rng);
    } while (l.x < 0.05 || l.y < 0.05);
    v[1] = dvec3(rng.range(-10, 10), rng.range(-10, 10), either_sign(rng, log_range(rng, 1e-7, 1e-3)));
    v[2] = dvec3(rng.range(-10, 10), rng.range(-10, 10), log_range(rng, 0.1, 20));
    v[0] = (hit - l.y * v[1] - l.z * v[2]) / l.x;
  } while (v[0].z <= 0);
  return sample_of(v, pixel, viewport);
}

// A plane that passes the eye at a distance of 10^low .. 10^high of that of the hit.
template <int low, int high>
ClipSample grazing(Pcg32& rng, uvec2 pixel, uvec2 viewport) {
  const double distance = log_range(rng, 0.5, 100);
  const dvec3 hit = clip_at(centre(pixel), distance, viewport);
  const double ratio = log_range(rng, std::pow(10.0, low), std::pow(10.0, high));
  const dvec3 ray = normalize(hit);
  const double angle = rng.range(0, 2 * kPi);
  const dvec3 aside = normalize(cross(ray, dvec3(std::cos(angle), std::sin(angle), 0.3)));
  const dvec3 across = cross(ray, aside);
  const dvec3 receding = normalize(ray * std::sqrt(1 - ratio * ratio) + across * ratio);
  std::array<dvec2, 3> p = fat_triangle(rng, uvec2(0), distance * log_range(rng, 0.01, 1));
  std::array<dvec3, 3> v;
  for (size_t k = 0; k < 3; ++k) {
    const dvec2 moved = p[k] - dvec2(0.5);
    v[k] = hit + moved.x * aside + moved.y * receding;
  }
  return sample_of(v, pixel, viewport);
}

constexpr uvec2 k4k = {3840, 2160}, k16k = {15360, 8640};
constexpr Goal kConditioned = {1e-6, 2.5e-7, 1e-5};
constexpr Goal kNoGoal = {kFree, kFree, kFree};

const InputClass kClasses[] = {
    {"typical", k4k, fat<3000, 100000>, kConditioned, "3 to 100 px: a rounding of the screen position is visible"},
    {"huge", k4k, fat<1000000, 5000000>, kConditioned, "1000 to 5000 px: a step of a stored weight is a pixel"},
    {"single_sample", k4k, fat<300, 2000>, kConditioned, "0.3 to 2 px: two thousand times less than the coordinates"},
    {"micro", k4k, fat<10, 300>, kConditioned, "0.01 to 0.3 px: at the last bits of the coordinates"},
    {"sliver_1e-2", k4k, sliver<-2>, kNoGoal, "an area of 0.01 px^2 along up to 100 px"},
    {"sliver_1e-4", k4k, sliver<-4>, kNoGoal, "an area of 10^-4 px^2 along up to 100 px", true},
    {"sliver_1e-4_centre", k4k, central_sliver<-4>, kNoGoal, "the same, where coordinates can express it", true},
    {"sliver_1e-6_centre", k4k, central_sliver<-6>, kNoGoal, "an area of 10^-6 px^2: nothing of a float is left", true},
    {"crossing", k4k, crossing, {4e-6, kFree, kFree}, "one or two vertices behind the eye"},
    {"tiny_w", k4k, tiny_w, kNoGoal, "a vertex with |w| of 10^-7 to 10^-3"},
    {"grazing", k4k, grazing<-3, -1>, {2e-4, kFree, 5e-4}, "a floor seen at 10^-3 to 0.1 of its distance"},
    {"grazing_1e-5", k4k, grazing<-5, -3>, kNoGoal, "a floor seen at 10^-5 to 10^-3 of its distance"},
    {"fov_170", k4k, fat<3000, 100000, 60>, {5e-6, kFree, kFree}, "170 degrees: distances differ within a triangle"},
    {"16k", k16k, fat<3000, 100000>, kConditioned, "3 to 100 px of 15360 x 8640"},
    {"16k_huge", k16k, fat<5000000, 20000000>, kConditioned, "5000 to 20,000 px of 15360 x 8640"},
    {"16k_single_sample", k16k, fat<300, 2000>, kConditioned, "0.3 to 2 px of 15360 x 8640"},
};

}  // namespace

std::span<const InputClass> input_classes() { return kClasses; }

const InputClass& input_class(const std::string& name) {
  for (const InputClass& c : kClasses)
    if (c.name == name) return c;
  throw std::logic_error("no class of triangles is named " + name);
}

ClipSample any_sample(const InputClass& c, Pcg32& rng) {
  return c.make(rng, {rng.below(c.viewport.x), rng.below(c.viewport.y)}, c.viewport);
}

Case class_case(const InputClass& k, uint32_t count) {
  Pcg32 rng(1);
  std::vector<ClipSample> samples(count);
  for (ClipSample& s : samples) s = any_sample(k, rng);
  return clip_case(k.name, samples, 64);
}

}  // namespace assay::attribute_interpolation
