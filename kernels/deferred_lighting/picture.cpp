#include "kernels/deferred_lighting/picture.h"

#include <algorithm>
#include <cmath>

#include "harness/clusters.h"
#include "harness/formats/visibility.h"
#include "harness/half.h"
#include "harness/vrcs_lists.h"
#include "harness/vrcs_screens.h"
#include "kernels/deferred_lighting/oracle.h"

namespace assay::deferred_lighting {

using glm::dvec3;

namespace {

constexpr double kNear = 0.1;

int16_t snorm(double v) { return static_cast<int16_t>(std::lround(std::clamp(v, -1.0, 1.0) * 32767)); }

// The nearest hit of a ray from the eye: view depth along it and the normal there.
struct Hit {
  double depth = 1e30;
  dvec3 normal = {};
  int what = -1;
};

void hit_plane(Hit& hit, const dvec3& ray, const dvec3& normal, double offset, int what) {
  const double along = glm::dot(normal, ray), t = offset / along;
  if (along < 0 && t > 0 && t < hit.depth) hit = {t, normal, what};
}

void hit_ball(Hit& hit, const dvec3& ray, const dvec3& centre, double radius, int what) {
  const double a = glm::dot(ray, ray), b = glm::dot(ray, centre), c = glm::dot(centre, centre) - radius * radius;
  const double d = b * b - a * c;
  if (d < 0) return;
  const double t = (b - std::sqrt(d)) / a;
  if (t > 0 && t < hit.depth) hit = {t, glm::normalize(ray * t - centre), what};
}

constexpr int kBalls = 10;
constexpr double kBallRadius = 0.7;
dvec3 ball(int i) { return {-3.2 + 1.6 * (i % 5), i < 5 ? -0.9 : 0.9, i < 5 ? -4.5 : -6}; }

Hit look(const dvec3& ray) {
  Hit hit;
  hit_plane(hit, ray, {0, 1, 0}, -1.6, kBalls);
  hit_plane(hit, ray, {0, 0, 1}, -9, kBalls + 1);
  hit_plane(hit, ray, {1, 0, 0}, -5, kBalls + 2);
  for (int i = 0; i < kBalls; ++i) hit_ball(hit, ray, ball(i), kBallRadius, i);
  return hit;
}

}  // namespace

dvec3 Picture::ray(double x, double y) const {
  return dvec3(params.rays.corner) + dvec3(params.rays.across) * x + dvec3(params.rays.down) * y;
}
dvec3 Picture::position(uint32_t x, uint32_t y) const {
  return ray(x + 0.5, y + 0.5) * (double{params.near_plane} / double{depth[at(x, y)]});
}
void Picture::place(uint32_t x, uint32_t y, double view_depth) {
  depth[at(x, y)] = static_cast<float>(double{params.near_plane} / view_depth);
}
void Picture::face(uint32_t x, uint32_t y, const dvec3& n) { normal[at(x, y)] = octahedral_code(n); }

// 1/w is linear on a plane in the screen, n.ray over a constant.
void Picture::lean(uint32_t x, uint32_t y, const dvec3& n) {
  if (gradients.empty()) gradients.resize(depth.size());
  const double here = glm::dot(n, ray(x + 0.5, y + 0.5));
  gradients[at(x, y)] = {half_bits(glm::dot(n, dvec3(params.rays.across)) / here),
                         half_bits(glm::dot(n, dvec3(params.rays.down)) / here)};
}

uint32_t octahedral_code(const dvec3& n) {
  const double sum = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
  double x = n.x / sum, y = n.y / sum;
  if (n.z < 0) {
    const double folded = (1 - std::fabs(y)) * (x < 0 ? -1 : 1);
    y = (1 - std::fabs(x)) * (y < 0 ? -1 : 1);
    x = folded;
  }
  return static_cast<uint16_t>(snorm(x)) | static_cast<uint32_t>(static_cast<uint16_t>(snorm(y))) << 16;
}

uint32_t base_code(uint32_t red, uint32_t green, uint32_t blue, uint32_t roughness) {
  return red | green << 8 | blue << 16 | roughness << 24;
}

Picture wall(Extent e, double view_depth) {
  const size_t n = pixel_count(e);
  const double down = static_cast<double>(e.height) / static_cast<double>(e.width);
  Picture p = {.extent = e};
  p.params.rays = {vec3(-1, down, -1), vec3(2.0 / e.width, 0, 0), vec3(0, -2 * down / e.height, 0)};
  p.params.near_plane = static_cast<float>(kNear);
  p.params.ambient = vec3(0.02f, 0.03f, 0.04f);
  p.depth.assign(n, static_cast<float>(kNear / view_depth));
  p.base.assign(n, base_code(180, 170, 160, 128));
  p.normal.assign(n, octahedral_code({0, 0, 1}));
  p.metal.assign(n, metal_code(0, 255));
  p.emissive.assign(n, 0);
  p.features.assign(n, kFeatureOpaque);
  return p;
}

Picture hall(Extent e) {
  Picture p = wall(e);
  p.visibility.assign(p.depth.size(), uvec2(kVisibilityNone));
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      const size_t i = p.at(x, y);
      const Hit hit = look(p.ray(x + 0.5, y + 0.5));
      if (hit.what >= 0) p.visibility[i] = {y / 23 * 4096 + x / 25, static_cast<uint32_t>(hit.what)};
      if (hit.what < 0) {
        p.depth[i] = 0, p.base[i] = 0, p.normal[i] = 0, p.metal[i] = 0, p.features[i] = 0;
        continue;
      }
      p.place(x, y, hit.depth);
      p.face(x, y, hit.normal);
      if (hit.what < kBalls) {
        const auto k = static_cast<uint32_t>(hit.what);
        p.base[i] = base_code(220 - 12 * k, 120 + 10 * k, 90 + 15 * k, 25 * k);
        p.metal[i] = metal_code(k % 3 == 0 ? 255 : 0, 255);
        if (k == 7) p.features[i] |= kFeatureCloth;
        if (k == 8) p.features[i] |= kFeatureSkin;
        if (k == 4) p.features[i] |= kFeatureSubsurface;
      } else if (hit.what == kBalls) {
        const dvec3 at = p.position(x, y);
        const bool dark = (static_cast<int>(std::floor(at.x)) + static_cast<int>(std::floor(at.z))) % 2 != 0;
        p.base[i] = dark ? base_code(90, 90, 100, 70) : base_code(190, 185, 180, 110);
      }
    }
  return p;
}

void add_cells(Picture& p, Extent cell, const std::vector<float>& depths,
               const std::function<std::vector<uint32_t>(uint32_t)>& lights_in) {
  p.params.grid = grid_over(p.extent, cell, static_cast<uint32_t>(depths.size()) - 1);
  p.slice_edges = reversed_slice_edges(depths, p.params.near_plane);
  const ClusterGrid& g = p.params.grid;
  for (uint32_t i = 0; i < g.columns * g.rows * g.slices; ++i) {
    const std::vector<uint32_t> lights = lights_in(i);
    p.cells.emplace_back(p.entries.size(), lights.size());
    p.entries.insert(p.entries.end(), lights.begin(), lights.end());
  }
}

namespace {

// Few lights are in all cells; of more, each cell has about eight.
void add_some_cells(Picture& p) {
  Pcg32 rng(p.lights.size());
  const auto all = static_cast<uint32_t>(p.lights.size());
  add_cells(p, {24, 40}, slice_edges(1, 60, 5), [&](uint32_t) {
    std::vector<uint32_t> some;
    for (uint32_t i = 0; i < all && some.size() < kMaxClusterEntries; ++i)
      if (all <= 8 || rng.below(all) < 8) some.push_back(i);
    return some;
  });
}

// The lesser of a pixel's two differences along one side, over its depth.
uint16_t lesser_step(const Picture& p, uint32_t along, uint32_t length, size_t here, size_t stride) {
  const double d = p.depth[here];
  if (!has_surface(p.depth[here])) return 0;
  double least = 0;
  bool is_first = true;
  const auto look = [&](double step) {
    if (is_first || std::fabs(step) < std::fabs(least)) least = step;
    is_first = false;
  };
  if (along > 0 && has_surface(p.depth[here - stride])) look(d - p.depth[here - stride]);
  if (along + 1 < length && has_surface(p.depth[here + stride])) look(p.depth[here + stride] - d);
  return half_bits(std::clamp(least / d, -kLargestHalf, kLargestHalf));
}
std::vector<std::array<uint16_t, 2>> gradients_of(const Picture& p) {
  std::vector<std::array<uint16_t, 2>> gradients;
  for (uint32_t y = 0; y < p.extent.height; ++y)
    for (uint32_t x = 0; x < p.extent.width; ++x)
      gradients.push_back({lesser_step(p, x, p.extent.width, p.at(x, y), 1),
                           lesser_step(p, y, p.extent.height, p.at(x, y), p.extent.width)});
  return gradients;
}

void set_shadows(Case& c, const Picture& p) {
  c.set_input("depth_gradients", p.gradients.empty() ? gradients_of(p) : p.gradients);
  c.set_input("shadow_views", p.atlas.views);
  c.set_input("shadow_depth", p.atlas.depths);
}

}  // namespace

Case to_case(const std::string& name, const Picture& p) {
  if (p.cells.empty()) {
    Picture with_cells = p;
    add_some_cells(with_cells);
    return to_case(name, with_cells);
  }
  Case c = {.name = name, .extent = p.extent};
  LightingParams params = p.params;
  params.entries = static_cast<uint32_t>(p.entries.size());
  params.width = p.extent.width, params.height = p.extent.height;
  params.lights = static_cast<uint32_t>(p.lights.size());
  params.shadow_views = static_cast<uint32_t>(p.atlas.views.size());
  params.shadow_width = p.atlas.extent.width, params.shadow_height = p.atlas.extent.height;
  c.set_params(params);
  c.set_input("depth", p.depth);
  c.set_input("base_roughness", p.base);
  c.set_input("normal", p.normal);
  c.set_input("metallic_occlusion", p.metal);
  c.set_input("emissive", p.emissive);
  c.set_input("features", p.features);
  c.set_input("lights", p.lights);
  c.set_input("cells", p.cells);
  c.set_input("entries", p.entries);
  c.set_input("slice_edges", p.slice_edges);
  set_shadows(c, p);
  set_primaries(c, p);
  return c;
}

std::vector<uvec2> covered_by_depth(const Picture& p) {
  std::vector<uvec2> visibility;
  for (uint32_t y = 0; y < p.extent.height; ++y)
    for (uint32_t x = 0; x < p.extent.width; ++x)
      visibility.push_back(has_surface(p.depth[p.at(x, y)]) ? uvec2(y / 7 * 4096 + x / 5, 1) : uvec2(kVisibilityNone));
  return visibility;
}

void set_primaries(Case& c, const Picture& p) {
  const auto visibility = p.visibility.empty() ? covered_by_depth(p) : p.visibility;
  Pcg32 rng(p.extent.width, p.extent.height);
  const auto rates = p.rates.empty() ? vrcs::rates_in_blocks(p.extent, rng, 2) : p.rates;
  const auto coordinates =
      vrcs::coordinates_of({.extent = p.extent, .visibility = visibility, .rates = rates, .frame = p.params.frame});
  const vrcs::Lists lists = vrcs::lists_of(coordinates);
  c.set_input("visibility", visibility);
  c.set_input("tiles", lists.tiles);
  c.set_input("tile_entries", lists.entries);
  vrcs::set_screen_list(c, coordinates.tiles, rng);
}

void add_hall_shadows(Picture& p) {
  constexpr uint32_t kSide = 128;
  constexpr double kReach = 20;
  p.atlas = shadowing::Atlas({kCubeFaces * kSide, 3 * kSide});
  LightRecord &sun = p.lights[0], &lamp = p.lights[1], &cone = p.lights[2];
  sun.first_view = 0, sun.views = 3;
  for (uint32_t i = 0; i < sun.views; ++i)
    p.atlas.add_cascade({i * kSide, 0, kSide}, {0, 0, -4}, dvec3(sun.direction), 3 << i, 20, kReach);
  lamp.first_view = p.atlas.add_cube({0, kSide, kSide}, dvec3(lamp.position), 0.1, kReach), lamp.views = kCubeFaces;
  cone.views = 1, cone.first_view = p.atlas.add_spot({0, 2 * kSide, kSide}, dvec3(cone.position), dvec3(cone.direction),
                                                     0.7, 0.1, kReach);
  for (const LightRecord& light : {sun, lamp, cone})
    for (int i = 0; i < kBalls; ++i) {
      const dvec3 ray = light.kind == kLightDirectional ? dvec3(light.direction) : ball(i) - dvec3(light.position);
      for (uint32_t view = 0; view < light.views; ++view)
        p.atlas.draw(light.first_view + view, {ball(i), ray, kBallRadius});
    }
}

void add_shadows(Picture& p, Pcg32& rng) {
  constexpr uint32_t kLights = 8, kSide = 32;
  p.atlas = shadowing::Atlas({kLights * kSide, kLights * kSide});
  for (uint32_t i = 0; i < std::min<size_t>(p.lights.size(), kLights); ++i) {
    const uint32_t x = rng.below(p.extent.width), y = rng.below(p.extent.height);
    const dvec3 seen = has_surface(p.depth[p.at(x, y)]) ? p.position(x, y) : p.ray(x, y) * 3.0;
    p.atlas.add_light({0, i * kSide, kSide}, p.lights[i], seen, rng);
  }
}

void add_lights(Picture& p, Pcg32& rng, uint32_t count, double reach) {
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x = rng.below(p.extent.width), y = rng.below(p.extent.height);
    p.lights.push_back(random_light(rng, p.depth[p.at(x, y)] > 0 ? p.position(x, y) : p.ray(x, y) * 3.0, reach));
  }
}

}  // namespace assay::deferred_lighting
