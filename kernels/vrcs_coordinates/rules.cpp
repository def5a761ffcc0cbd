#include "kernels/vrcs_coordinates/rules.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "harness/oracle.h"

namespace assay::vrcs_coordinates {

namespace {

// A positive normal number as mantissa * 2^exponent, the mantissa from 2^23 to 2^24.
struct Depth {
  int64_t mantissa = 0;
  int exponent = 0;
};
std::optional<Depth> depth_of(float d) {
  if (vrcs::depth_of(d) == 0) return {};
  int exponent;
  const auto mantissa = static_cast<int64_t>(std::ldexp(std::frexp(d, &exponent), 24));
  return Depth{mantissa, exponent - 24};
}

// `d` in units of 2^exponent, rounded down.
int64_t in_units(Depth d, int exponent) {
  const int up = d.exponent - exponent;
  if (up >= 0) return d.mantissa << up;
  return up > -24 ? d.mantissa >> -up : 0;
}

// The difference in units of the greater's last place, the smaller rounded down to such units.
bool close_depths(float a, float b, uint log2) {
  const auto greater = depth_of(std::max(a, b)), smaller = depth_of(std::min(a, b));
  if (std::isnan(a) || std::isnan(b) || !greater || !smaller) return false;
  return greater->mantissa - in_units(*smaller, greater->exponent) <= greater->mantissa >> std::min(log2, 23u);
}

using Direction = std::array<int64_t, 3>;

__int128 dot(const Direction& a, const Direction& b) {
  __int128 sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += __int128{a[i]} * b[i];
  return sum;
}

// sin^2 = 1 - (a.b)^2 / (|a|^2 |b|^2) <= 2^-log2, at an acute angle. No direction is close to none.
bool close_normals(const Direction& a, const Direction& b, uint log2) {
  const __int128 along = dot(a, b), whole = dot(a, a) * dot(b, b);
  return along > 0 && whole - along * along <= whole >> std::min(log2, 31u);
}

Direction octahedral(uint code) {
  const auto snorm = [](uint16_t bits) { return std::max<int64_t>(static_cast<int16_t>(bits), -32767); };
  const int64_t x = snorm(static_cast<uint16_t>(code)), y = snorm(static_cast<uint16_t>(code >> 16));
  const int64_t z = 32767 - std::abs(x) - std::abs(y);
  if (z >= 0) return {x, y, z};
  return {(32767 - std::abs(y)) * (x < 0 ? -1 : 1), (32767 - std::abs(x)) * (y < 0 ? -1 : 1), z};
}

int bits_of(int64_t magnitude) { return static_cast<int>(std::bit_width(static_cast<uint64_t>(magnitude))); }

struct Screen {
  Extent extent;
  std::span<const uvec2> visibility;
  std::span<const float> depth;
  int64_t focal_x, focal_y;
};

struct Sample {  // relative to the pixel that a normal is rebuilt at
  int64_t x = 0, y = 0, depth = 0;
};

// Over a plane reversed depth is linear on the screen, and its slopes there are the view-space normal's components,
// over the focal lengths. Slopes are cut to 15 bits, the normal to 14, towards minus infinity.
Direction normal_of(const Screen& s, int64_t x, int64_t y, int64_t depth, Sample a, Sample b) {
  const int64_t area = a.x * b.y - a.y * b.x, sign = area < 0 ? -1 : 1;
  int64_t slope_x = sign * (a.depth * b.y - b.depth * a.y), slope_y = sign * (b.depth * a.x - a.depth * b.x);
  const int steep = std::max(bits_of(std::max(std::abs(slope_x), std::abs(slope_y))) - 15, 0);
  slope_x >>= steep, slope_y >>= steep;
  const int64_t base = (sign * area * depth) >> steep;
  Direction n = {2 * slope_x * s.focal_x, 2 * slope_y * s.focal_y,
                 2 * base - slope_x * (2 * x + 1 - s.extent.width) - slope_y * (2 * y + 1 - s.extent.height)};
  const int excess = bits_of(std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])})) - 14;
  for (int64_t& v : n) v >>= std::max(excess, 0);
  return n;
}

// In rows, those around the pixel in its 8x8 block that show its triangle at a depth of its power of two or one beside.
std::vector<Sample> samples_around(const Screen& s, int64_t x, int64_t y, Depth here) {
  std::vector<Sample> samples;
  const size_t at = static_cast<size_t>(y * s.extent.width + x);
  for (int64_t v = std::max(y - 1, y / 8 * 8); v <= y + 1 && v < y / 8 * 8 + 8 && v < s.extent.height; ++v)
    for (int64_t u = std::max(x - 1, x / 8 * 8); u <= x + 1 && u < x / 8 * 8 + 8 && u < s.extent.width; ++u) {
      const size_t there = static_cast<size_t>(v * s.extent.width + u);
      const auto depth = depth_of(s.depth[there]);
      if (there == at || s.visibility[there] != s.visibility[at] || !depth) continue;
      if (std::abs(depth->exponent - here.exponent) <= 1)
        samples.push_back({u - x, v - y, in_units(*depth, here.exponent) - here.mantissa});
    }
  return samples;
}

// The first sample, and the first that is not in line with it and the pixel; zero where there are none.
Direction rebuilt(const Screen& s, size_t at) {
  const auto here = depth_of(s.depth[at]);
  if (!here) return {};
  const auto x = static_cast<int64_t>(at % s.extent.width), y = static_cast<int64_t>(at / s.extent.width);
  const auto samples = samples_around(s, x, y, *here);
  for (const Sample& b : samples)
    if (samples[0].x * b.y != samples[0].y * b.x) return normal_of(s, x, y, here->mantissa, samples[0], b);
  return {};
}

}  // namespace

vrcs::Sharing same_surface(const Case& c) {
  const auto p = c.params<VrcsParams>();
  return [p, seen = c.input<uvec2>("visibility"), depth = c.input<float>("depth")](size_t a, size_t b) {
    return seen[a].y % (1u << 30) == seen[b].y % (1u << 30) && close_depths(depth[a], depth[b], p.close_depths_log2);
  };
}

vrcs::Sharing stored_normal(const Case& c) {
  const auto p = c.params<VrcsParams>();
  return [p, normals = c.input<uint>("face_normals"), depth = c.input<float>("depth")](size_t a, size_t b) {
    return close_depths(depth[a], depth[b], p.close_depths_log2) &&
           close_normals(octahedral(normals[a]), octahedral(normals[b]), p.close_normals_log2);
  };
}

vrcs::Sharing rebuilt_normal(const Case& c) {
  const auto p = c.params<VrcsParams>();
  const Screen s{c.extent, c.input<uvec2>("visibility"), c.input<float>("depth"), std::clamp(p.focal_x, 1u, 16383u),
                 std::clamp(p.focal_y, 1u, 16383u)};
  return [p, s](size_t a, size_t b) {
    return close_depths(s.depth[a], s.depth[b], p.close_depths_log2) &&
           close_normals(rebuilt(s, a), rebuilt(s, b), p.close_normals_log2);
  };
}

}  // namespace assay::vrcs_coordinates
