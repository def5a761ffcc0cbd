#include "harness/vrcs_scene.h"

#include <cmath>

#include "harness/oracle.h"

namespace assay::vrcs {

namespace {

constexpr int kPatch = 128;  // pixels
constexpr double kPi = 3.14159265358979;

double hashed(int64_t x, int64_t y, uint64_t salt) {
  return Pcg32(static_cast<uint64_t>(x * 73856093) ^ static_cast<uint64_t>(y * 19349663) ^ salt * 83492791).unit();
}
double smooth(double t) { return t * t * (3 - 2 * t); }

// Random values on a grid, interpolated: 0 to 1.
double noise(double x, double y, uint64_t salt) {
  const double u = std::floor(x), v = std::floor(y), s = smooth(x - u), t = smooth(y - v);
  const auto i = static_cast<int64_t>(u), j = static_cast<int64_t>(v);
  const double upper = std::lerp(hashed(i, j, salt), hashed(i + 1, j, salt), s);
  return std::lerp(upper, std::lerp(hashed(i, j + 1, salt), hashed(i + 1, j + 1, salt), s), t);
}
double octaves(double x, double y, double longest, uint64_t salt) {
  double sum = 0, weight = 0.5;
  for (uint k = 0; k < 4; ++k, weight /= 2, longest /= 2) sum += weight * noise(x / longest, y / longest, salt + k);
  return sum;
}
}  // namespace

double stripes(double along, double period) { return 0.5 + 0.4 * std::sin(2 * kPi * along / period); }

double scene(double x, double y) {
  const double column = std::floor((x - 37.3) / kPatch), row = std::floor((y - 21.7) / kPatch);
  const auto patch = static_cast<uint64_t>((column + 8) * 16 + row + 8);
  const double angle = 2 * kPi * hashed(1, 2, patch), along = x * std::cos(angle) + y * std::sin(angle);
  switch (patch % 7) {
    case 0:
    case 1:
      return 0.5 + 0.4 * std::sin(along / 300 + static_cast<double>(patch));
    case 2:
      return 0.1 + 0.8 * octaves(x, y, 64, patch);
    case 3:
      return 0.2 + 0.6 * octaves(x, y, 6, patch);
    case 4:
      return std::fmod(std::fmod(along, 40) + 40, 40) < 20 ? 0.25 : 0.75;
    case 5:
      return stripes(along, 18);
    default:
      return stripes(along, 5.2);
  }
}

}  // namespace assay::vrcs
