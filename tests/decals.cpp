#include "tests/decals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace assay::tests {
namespace {

using glm::dvec2;
using glm::dvec3;
using scene::Decal;
using scene::Scene;

constexpr double kUnit = 1.0 / (1 << 24);  // of float's roundings
// The sampler's atlas: five levels, and what a device may make of a footprint: sqrt(2) of the sum of its derivatives,
// an eighth of a level, and the next whole level.
constexpr double kLastTexel = 16, kWidest = 2 * 1.41421357 * 1.0905078;

double view_depth(const scene::Camera& camera, const dvec3& position) {
  return -dot(mat3_cast(camera.orientation)[2], position);
}

// A channel's extremes over all texels that a sample there may hold a share of: those of the coarsest level that the
// footprint allows are means, so what their texels span bounds them; one more on each side for the linear filter.
Range extremes(const scene::Image& image, uint32_t channel, bool srgb, const dvec2& uv, double reach) {
  const dvec2 size(image.width, image.height), centre = uv * size;
  const auto within = [](double v, uint32_t n) {
    return static_cast<uint32_t>(std::clamp(v, 0.0, static_cast<double>(n) - 1));
  };
  uint8_t low = 255, high = 0;
  for (uint32_t y = within(centre.y - reach, image.height); y <= within(centre.y + reach, image.height); ++y)
    for (uint32_t x = within(centre.x - reach, image.width); x <= within(centre.x + reach, image.width); ++x) {
      const uint8_t code = image.rgba[(size_t{y} * image.width + x) * 4 + channel];
      low = std::min(low, code), high = std::max(high, code);
    }
  // A level's texel is rounded to a code, decoded within half of one; filters may work in 8 bits (filter.h).
  const SamplerRoom room;
  const auto value = [&](double code) {
    const double v = std::clamp(code / 255, 0.0, 1.0);
    return srgb ? srgb_to_linear(v) : v;
  };
  return Range{value(low - 1), value(high + 1)}.widened(srgb ? room.value_srgb : room.value);
}

Range clamped(const Range& r) { return {std::clamp(r.low, 0.0, 1.0), std::clamp(r.high, 0.0, 1.0)}; }
// a + (b - a) t of any t within: linear in each, so the extremes are at ends.
Range mixed(const Range& a, const Range& b, const Range& t) { return hull(mix(a, b, t.low), mix(a, b, t.high)); }

struct Sample {
  std::array<Range, 3> colour;
  Range coverage, roughness;
  dvec3 normal = {0, 0, 1};  // x along the picture, y up it
  double normal_error = 0;   // absolute
};

Sample sample(const Scene& s, const Decal& d, const dvec2& uv, const dvec2& per_x, const dvec2& per_y) {
  const auto reach_in = [&](const scene::Image& image) {
    const dvec2 size(image.width, image.height);
    const double rho = std::max(dot(abs(per_x), size), dot(abs(per_y), size));
    return 1.5 * std::clamp(kWidest * rho * 1.01, 1.0, kLastTexel) + 1.0 / 16;
  };
  const auto channel = [&](uint32_t image, uint32_t c, bool srgb, double constant) {
    if (image == scene::kNone) return Range{constant, constant}.widened(0.6 / 255);  // kept as a code
    return clamped(extremes(s.images[image], c, srgb, uv, reach_in(s.images[image])));
  };
  Sample a;
  for (int c = 0; c < 3; ++c) {
    a.colour[static_cast<size_t>(c)] =
        d.colour_image != scene::kNone
            ? channel(d.colour_image, static_cast<uint32_t>(c), true, 0)
            : Range{srgb_to_linear(std::max(0.0, linear_to_srgb(double{d.colour[c]}) - 0.6 / 255)),
                    srgb_to_linear(std::min(1.0, linear_to_srgb(double{d.colour[c]}) + 0.6 / 255))};
  }
  a.coverage = clamped(channel(d.colour_image, 3, false, double{d.colour.w}));
  a.roughness = clamped(channel(d.roughness_image, 0, false, double{d.roughness}));
  const Range x = channel(d.normal_image, 0, false, 0.5), y = channel(d.normal_image, 1, false, 0.5);
  const auto direction = [](double u, double v) {
    const dvec2 n(2 * u - 1, 2 * v - 1);
    return dvec3(n, std::sqrt(std::max(0.0, 1 - dot(n, n))));
  };
  a.normal = direction((x.low + x.high) / 2, (y.low + y.high) / 2);
  // z falls with |xy|: its extremes are where xy is nearest to and farthest from 0.
  const auto ends = [](const Range& r) {
    const double low = std::abs(2 * r.low - 1), high = std::abs(2 * r.high - 1);
    return dvec2(r.low <= 0.5 && r.high >= 0.5 ? 0 : std::min(low, high), std::max(low, high));
  };
  const dvec2 ex = ends(x), ey = ends(y);
  const double z_high = std::sqrt(std::max(0.0, 1 - ex.x * ex.x - ey.x * ey.x)),
               z_low = std::sqrt(std::max(0.0, 1 - ex.y * ex.y - ey.y * ey.y));
  a.normal_error = std::hypot(x.high - x.low, y.high - y.low) + std::max(z_high - a.normal.z, a.normal.z - z_low);
  return a;
}

// A vector within `error`.
struct Near {
  dvec3 value;
  double error;
};

// The decal's and the surface's normal in the decal's frame, blended.
Near blended(const dvec3& base, const Sample& s, const Range& share, uint32_t mode) {
  const double middle = (share.low + share.high) / 2, spread = (share.high - share.low) / 2;
  const auto towards = [&](const dvec3& from) {
    return Near{from + (s.normal - from) * middle, share.high * s.normal_error + spread * length(s.normal - from)};
  };
  if (mode == kNormalLinear) return towards(base);
  const Near f = towards({0, 0, 1});
  if (mode == kNormalWhiteout) return {dvec3(base.x + f.value.x, base.y + f.value.y, base.z * f.value.z), f.error};
  // t (t.u) - u t.z with t = base + z and u = (-x, -y, z): of a unit base as long as t.z is, so is what it does to
  // errors.
  const dvec3 t = base + dvec3(0, 0, 1), u(-f.value.x, -f.value.y, f.value.z);
  return {t * dot(t, u) - u * t.z, f.error * t.z};
}

void lay(Decaled& r, const Decal& d, const dvec3 frame[3], const Sample& s, double fade) {
  Range share[3];
  for (int c = 0; c < 3; ++c) share[c] = clamped((double{d.weights[c]} * fade * s.coverage).widened(16 * kUnit));
  if (d.weights.x > 0) {
    for (size_t c = 0; c < 3; ++c) r.base[c] = mixed(r.base[c], s.colour[c], share[0]);
    r.touched[0] = true;
  }
  if (d.weights.y > 0) {
    const dvec3 base(dot(r.normal, frame[0]), dot(r.normal, frame[1]), dot(r.normal, frame[2]));
    const Near n = blended(base, s, share[1], d.normal_mode);
    // What the surface's normal was off turns the blend by twice that at most: |dn| <= 2 |dbase| in each mode, over the
    // blend's length.
    const double before = 2 * std::sin(std::min(r.normal_rad, 3.14) / 2) * (d.normal_mode == kNormalLinear ? 1 : 3);
    const double size = length(n.value), error = n.error + before;
    r.normal = normalize(frame[0] * n.value.x + frame[1] * n.value.y + frame[2] * n.value.z);
    r.normal_rad = error < size ? std::asin(error / size) + 16 * kUnit : 3.2;
    r.touched[1] = true;
  }
  if (d.weights.z > 0) r.roughness = mixed(r.roughness, s.roughness, share[2]), r.touched[2] = true;
}

}  // namespace

InBox in_box(const Scene& s, const Decal& d, const dvec3& world) {
  const glm::dmat4 place = d.receiver == scene::kNone ? glm::dmat4(1) : s.instances[d.receiver].to_world;
  const glm::dmat3 back = inverse(glm::dmat3(place)), axes = mat3_cast(normalize(d.orientation));
  glm::dmat3 by = transpose(axes) * back;
  for (int column = 0; column < 3; ++column) by[column] /= d.half_extents;
  return {by * (world - dvec3(place[3])) - transpose(axes) * d.centre / d.half_extents, by};
}

Decaled decaled(const Scene& s, const scene::Camera& camera, const GBufferPixel& before, const dvec3& position,
                const dvec3& per_x, const dvec3& per_y) {
  Decaled r;
  for (size_t c = 0; c < 3; ++c) {
    const double root = before.base_roughness[c] / 255.0;
    r.base[c] = Range{root * root, root * root};
  }
  r.roughness = {before.base_roughness[3] / 255.0, before.base_roughness[3] / 255.0};
  r.normal = octahedral_direction(before.normal);
  r.normal_rad = 16 * kUnit;
  for (const Decal& d : s.decals) {
    const InBox box = in_box(s, d, camera.eye + position);
    const dvec3 origin =
        d.receiver == scene::kNone ? dvec3(0) : dvec3(s.instances[d.receiver].to_world[3]) - camera.eye;
    bool inside = true, beyond = false;
    for (int i = 0; i < 3; ++i) {
      const dvec3 row(box.by_position[0][i], box.by_position[1][i], box.by_position[2][i]);
      // 64 u of the lengths that a renderer in floats adds up (harness/scene/gather_decals.cpp), as a share of the box.
      const double off = 64 * kUnit * (length(row) * (length(position) + length(origin)) + 2);
      inside = inside && std::abs(box.at[i]) < 1 - off;
      beyond = beyond || !(std::abs(box.at[i]) <= 1 + off);
    }
    if (beyond) continue;
    r.at_face = r.at_face || !inside;
    const auto in_picture = [](const dvec3& q) { return dvec2(q.x, -q.y) / 2.0; };
    const double depth = view_depth(camera, position),
                 fade = d.fade_distance > 0 ? std::clamp(4 * (1 - depth / double{d.fade_distance}), 0.0, 1.0) : 1;
    const glm::dmat3 back = inverse(box.by_position);
    // x and y of the normals lie along the picture; z is square to it.
    const dvec3 frame[3] = {normalize(back[0]), normalize(back[1]),
                            normalize(dvec3(box.by_position[0][2], box.by_position[1][2], box.by_position[2][2]))};
    lay(r, d, frame,
        sample(s, d, in_picture(box.at) + 0.5, in_picture(box.by_position * per_x),
               in_picture(box.by_position * per_y)),
        fade);
  }
  return r;
}

std::string disagreement(const Decaled& r, const GBufferPixel& before, const GBufferPixel& after) {
  std::string all;
  const auto add = [&](const std::string& what) { all += (all.empty() || what.empty() ? "" : "; ") + what; };
  const auto untouched = [&](const char* what, bool same) { add(same ? "" : std::string(what) + " is touched"); };
  static const char* names[] = {"base red", "base green", "base blue"};
  for (size_t c = 0; c < 3; ++c) {
    if (r.touched[0])
      add(outside(names[c], after.base_roughness[c] / 255.0, stored(rooted(r.base[c]))));
    else
      untouched(names[c], after.base_roughness[c] == before.base_roughness[c]);
  }
  if (r.touched[2])
    add(outside("roughness", after.base_roughness[3] / 255.0, stored(r.roughness)));
  else
    untouched("roughness", after.base_roughness[3] == before.base_roughness[3]);
  if (!r.touched[1]) {
    untouched("the normal", after.normal == before.normal);
    return all;
  }
  const dvec3 got = octahedral_direction(after.normal);
  const double angle = std::atan2(length(cross(got, r.normal)), dot(got, r.normal));
  add(outside("angle between normals", angle, {0, r.normal_rad + kOctahedralError_rad}));
  return all;
}

}  // namespace assay::tests
