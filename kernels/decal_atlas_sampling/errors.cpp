// How far filtering is off: base colour against the mean over the ellipse that a pixel takes in of the atlas's first
// level.
#include <algorithm>
#include <cmath>

#include "harness/block_decoder.h"
#include "harness/known.h"
#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr Extent kExtent = {96, 96};

AtlasPlan plan_of(AtlasPlan::Look look, uint32_t border) {
  return {.width = 512, .height = 512, .side = 256, .levels = 6, .pages = 1, .border = border, .look = look};
}

// One decal over the screen, a wall seen straight on or a floor.
Case class_case(AtlasPlan::Look look, double texels_a_pixel, bool on_floor, uint32_t border) {
  View v(kExtent);
  v.atlas = plan_of(look, border);
  const double half =
      8 * (256.0 - 2 * border) / texels_a_pixel / kExtent.width;  // 8 m away, where the screen is 16 m wide
  if (on_floor) {
    v.set_plane(0, kExtent.height / 2 + 4, kExtent.width, kExtent.height, {0, -1.5, 0}, {0, 1, 0});
    v.decals = {decal({0, -1.5, -8}, {0, 1, 0}, 0.3, {half, half, 1}, v.atlas, 1)};
  } else {
    v.set_plane(0, 0, kExtent.width, kExtent.height, {0, 0, -8}, {0, 0, 1});
    v.decals = {decal({0, 0, -8}, {0, 0, 1}, 0.3, {half, half, 1}, v.atlas, 1)};
  }
  return v.to_case();
}

double linear_of(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

// Of the first level, colours linear; bilinear between texel centres.
dvec4 texel_at(const Texture& t, int x, int y) {
  dvec4 v;
  for (int c = 0; c < 4; ++c) {
    const size_t at = (static_cast<size_t>(y) * t.width + static_cast<size_t>(x)) * 4 + static_cast<size_t>(c);
    const double code = std::to_integer<int>(t.bytes[at]) / 255.0;
    v[c] = c < 3 ? linear_of(code) : code;
  }
  return v;
}
// `low` and `high` are the decal's own texels, the coordinate is held between their centres.
dvec4 bilinear(const Texture& t, dvec2 at, dvec2 low, dvec2 high) {
  at = glm::min(glm::max(at - 0.5, low), high - 1.0);
  const dvec2 whole = glm::floor(at), part = at - whole;
  const int x = static_cast<int>(whole.x), y = static_cast<int>(whole.y);
  const int x1 = std::min(x + 1, static_cast<int>(high.x) - 1), y1 = std::min(y + 1, static_cast<int>(high.y) - 1);
  return glm::mix(glm::mix(texel_at(t, x, y), texel_at(t, x1, y), part.x),
                  glm::mix(texel_at(t, x, y1), texel_at(t, x1, y1), part.x), part.y);
}

// The mean over the disc of a pixel's area about it, its radius 1 / sqrt(pi), by 32 x 32 points.
template <class F>
dvec4 mean_over_disc(F at) {
  constexpr int kPoints = 32;
  const double radius = 1 / std::sqrt(3.141592653589793);
  dvec4 sum(0);
  int count = 0;
  for (int j = 0; j < kPoints; ++j)
    for (int i = 0; i < kPoints; ++i) {
      const dvec2 p = dvec2(i + 0.5, j + 0.5) / (kPoints / 2.0) - 1.0;
      if (glm::dot(p, p) > 1) continue;
      sum += at(p * radius);
      ++count;
    }
  return sum / double(count);
}

// Where pixels' positions lie in the box: rows times w (corner + across x + down y), on a plane.
struct Plane {
  const Case& c;
  DecalParams p = c.params<DecalParams>();
  DecalRecord d = c.input<DecalRecord>("decals")[0];
  dvec3 box(uint32_t x, uint32_t y, dvec2 offset) const {
    const size_t pixel = size_t{y} * p.width + x;
    const dvec3 ray =
        dvec3(p.rays.corner) + dvec3(p.rays.across) * (x + 0.5 + offset.x) + dvec3(p.rays.down) * (y + 0.5 + offset.y);
    // Reversed depth is linear in the screen. The stored gradient is a half; the surface's normal says it exactly.
    const bool on_floor = d.outward.y > 0.5f;
    const double w = on_floor ? -1.5 / ray.y : double{p.near_plane} / c.input<float>("depth")[pixel];
    const dvec4 at = dvec4(ray * w, 1);
    return {glm::dot(dvec4(d.row_x), at), glm::dot(dvec4(d.row_y), at), glm::dot(dvec4(d.row_z), at)};
  }
};

bool is_well_inside(const dvec3& q) { return std::min({q.x, q.y, q.z}) > 0.02 && std::max({q.x, q.y, q.z}) < 0.98; }

// Codes that blocks are off what they were made of, over the decal's texels and channels: the worst level's mean.
double mean_of_compression(const Case& c, uint32_t page, dvec2 bias, dvec2 scale) {
  const Texture &source = c.textures.at("atlas")[kAtlasAlbedo], &blocks = c.textures.at("atlas_blocks")[kAtlasAlbedo];
  double worst = 0;
  for (uint32_t level = 0; level < source.levels; ++level) {
    const Bytes decoded = decoded_level(blocks, page, level).low;
    const uint32_t width = width_of(source, level), height = height_of(source, level);
    const dvec2 low = bias * dvec2(width, height), high = (bias + scale) * dvec2(width, height);
    const std::byte* from = source.bytes.data() + offset_of(source, level, page);
    double sum = 0, count = 0;
    for (auto y = static_cast<uint32_t>(low.y); y < high.y; ++y)
      for (auto x = static_cast<uint32_t>(low.x); x < high.x; ++x)
        for (uint32_t channel = 0; channel < 4; ++channel, ++count) {
          const size_t at = 4 * (size_t{y} * width + x) + channel;
          sum += std::abs(std::to_integer<int>(decoded[at]) - std::to_integer<int>(from[at]));
        }
    worst = std::max(worst, sum / count);
  }
  return worst;
}

// The red, green and blue codes that pixels well inside the decal should have, unrounded.
struct Truth {
  size_t pixel;
  dvec3 codes;
};
std::vector<Truth> truth_of(const Case& c, const Plane& plane, dvec2 bias, dvec2 scale) {
  const Texture& albedo = c.textures.at("atlas")[kAtlasAlbedo];
  const dvec2 size(albedo.width, albedo.height);
  const auto before = c.input<uint32_t>("base_roughness");
  std::vector<Truth> all;
  for (uint32_t y = 0; y < c.extent.height; ++y)
    for (uint32_t x = 0; x < c.extent.width; ++x) {
      Truth t = {size_t{y} * c.extent.width + x, {}};
      if (!(c.input<float>("depth")[t.pixel] > 0) || !is_well_inside(plane.box(x, y, dvec2(0)))) continue;
      const dvec4 sample = mean_over_disc([&](dvec2 offset) {
        const dvec3 q = plane.box(x, y, offset);
        return bilinear(albedo, (dvec2(q.x, q.y) * scale + bias) * size, bias * size, (bias + scale) * size);
      });
      for (int channel = 0; channel < 3; ++channel) {
        const double base = (before[t.pixel] >> 8 * channel & 255) / 255.0;
        t.codes[channel] = 255 * std::sqrt(base * base + (sample[channel] - base * base) * sample[3]);
      }
      all.push_back(t);
    }
  return all;
}

std::vector<Figure> figures(const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
  static Known<std::vector<Truth>> known;
  const Plane plane{c};
  const dvec2 scale(plane.d.scale_bias.x, plane.d.scale_bias.y), bias(plane.d.scale_bias.z, plane.d.scale_bias.w);
  const Bytes& got = written.at("base_roughness");
  std::vector<double> errors;
  for (const auto& [pixel, codes] : known.at(c.name, [&] { return truth_of(c, plane, bias, scale); }))
    for (int channel = 0; channel < 3; ++channel)
      errors.push_back(std::fabs(std::to_integer<int>(got[pixel * 4 + static_cast<size_t>(channel)]) - codes[channel]));
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  double sum = 0;
  for (const double e : errors) sum += e;
  const bool is_of_blocks = v.name == "block_compressed";
  return {{"codes, mean", sum / static_cast<double>(errors.size())},
          {"codes, p99", errors[errors.size() * 99 / 100]},
          {"blocks, mean", is_of_blocks ? mean_of_compression(c, plane.d.page, bias, scale) : 0}};
}

}  // namespace

ErrorTable error_table() {
  ErrorTable t = {.classes = {}, .figures = figures};
  const auto add = [&](const char* name, const char* why, AtlasPlan::Look look, double texels, bool on_floor,
                       uint32_t border = 18) {
    t.classes.push_back({name, why, [=] {
                           Case c = class_case(look, texels, on_floor, border);
                           c.name = name;
                           return c;
                         }});
  };
  add("wall, half a texel a pixel", "magnified", AtlasPlan::Look::stripes, 0.5, false);
  add("wall, 1.4 texels a pixel", "between two levels", AtlasPlan::Look::stripes, 1.4, false);
  add("wall, 5 texels a pixel", "stripes nearly as wide as a pixel", AtlasPlan::Look::stripes, 5, false);
  add("wall, 5 texels a pixel, no border", "coordinates are held away from the sides", AtlasPlan::Look::stripes, 5,
      false, 0);
  add("floor", "from magnified at the feet to two texels wide and twenty deep", AtlasPlan::Look::stripes, 1, true);
  add("floor, painted", "the same of a smooth picture", AtlasPlan::Look::painted, 1, true);
  return t;
}

}  // namespace assay::decal_atlas_sampling
