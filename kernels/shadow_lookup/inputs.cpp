#include "kernels/shadow_lookup/inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/shadow_oracle.h"
#include "kernels/shadow_lookup/oracle.h"

namespace assay::shadow_lookup {

using glm::dvec3;
using shadowing::Caster;

uint32_t Setup::add_light(uint32_t kind, const dvec3& position, const dvec3& direction, uint32_t first_view,
                          uint32_t views) {
  lights.push_back({vec3(position), 0, vec3(1), kind, vec3(direction), 0, 1, first_view, views});
  return static_cast<uint32_t>(lights.size()) - 1;
}
void Setup::receive(uint32_t light, const dvec3& position, const dvec3& normal, double dither) {
  receivers.push_back({vec3(position), light, vec3(normal), static_cast<float>(dither)});
}

namespace {

Case case_of(const Setup& s, Extent extent) {
  Case c = {.extent = extent};
  c.set_params(LookupParams{static_cast<uint>(s.receivers.size()), static_cast<uint>(s.lights.size()),
                            static_cast<uint>(s.atlas.views.size()), s.atlas.extent.width, s.atlas.extent.height});
  c.set_input("receivers", s.receivers);
  c.set_input("lights", s.lights);
  c.set_input("shadow_views", s.atlas.views);
  c.set_input("shadow_depth", s.atlas.depths);
  return c;
}

// ---- Random ----

constexpr uint32_t kCell = 40, kCells = 8;  // of the atlas: a row of cells a light
constexpr double kReach = 20;               // metres from the camera

dvec3 around(Pcg32& rng, double reach) {
  return {rng.range(-reach, reach), rng.range(-reach, reach), rng.range(-reach, reach)};
}
dvec3 any_direction(Pcg32& rng) {
  for (;;) {
    const dvec3 v = around(rng, 1);
    if (const double length = glm::length(v); length > 0.1 && length < 1) return v / length;
  }
}

void add_random_light(Setup& s, Pcg32& rng, uint32_t row) {
  const dvec3 position = dvec3(vec3(around(rng, 5))), direction = any_direction(rng);  // as the record holds it
  const auto first = static_cast<uint32_t>(s.atlas.views.size());
  const uint32_t sides[] = {1, 2, 3, 7, 16, 33, kCell, kCell};
  const uint32_t side = sides[rng.below(8)];
  ShadowTile tile = {rng.below(kCell - side + 1), row * kCell + rng.below(kCell - side + 1), side};
  const double near = rng.range(0.05, 0.3);
  switch (const uint32_t kind = rng.below(3)) {
    case kLightDirectional: {
      const uint32_t cascades = 1 + rng.below(kMostCascades);
      for (uint32_t i = 0; i < cascades; ++i, tile.x += kCell)
        s.atlas.add_cascade(tile, around(rng, 1), direction, 2.5 * std::exp2(i), rng.range(5, 25), kReach);
      s.add_light(kind, {}, direction, first, cascades);
      break;
    }
    case kLightPoint:
      s.add_light(kind, position, direction, s.atlas.add_cube({tile.x, tile.y, side}, position, near, kReach),
                  kCubeFaces);
      break;
    default:
      s.atlas.add_spot(tile, position, direction, rng.range(0.1, 1.3), near, kReach);
      s.add_light(kind, position, direction, first, 1);
  }
}

std::vector<Caster> random_casters(Pcg32& rng) {
  std::vector<Caster> casters(2 + rng.below(5));
  for (Caster& c : casters) c = {around(rng, 8), any_direction(rng), rng.below(3) ? rng.range(0.5, 6) : 1e30};
  return casters;
}

void add_noise(shadowing::Atlas& atlas, Pcg32& rng) {
  for (float& depth : atlas.depths) depth = rng.below(4) ? static_cast<float>(rng.unit()) : 0;
}

// A point of a caster that one of the light's views sees, else any near it.
void receive_on(Setup& s, Pcg32& rng, uint32_t light, const Caster& c) {
  const LightRecord& l = s.lights[light];
  const ShadowView& view = s.atlas.views[l.first_view + rng.below(l.views)];
  const auto p = shadowing::point_on(view, rng.range(-1.1, 1.1), rng.range(-1.1, 1.1), c);
  s.receive(light, p && glm::length(*p) < kReach ? *p : c.centre + around(rng, 2), c.normal, rng.unit());
}

void add_random_receivers(Setup& s, Pcg32& rng, const std::vector<Caster>& casters, uint64_t count) {
  while (s.receivers.size() < count) {
    const uint32_t light = rng.below(static_cast<uint32_t>(s.lights.size()));
    const Caster& c = casters[rng.below(static_cast<uint32_t>(casters.size()))];
    switch (rng.below(4)) {
      case 0:  // free in space, with a plane or without
        s.receive(light, around(rng, 10), rng.below(2) ? any_direction(rng) : dvec3(0), rng.unit());
        break;
      case 1:  // on a caster, in another plane
        receive_on(s, rng, light, {c.centre, any_direction(rng)});
        break;
      default:
        receive_on(s, rng, light, c);
    }
  }
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

template <class T>
void break_some(std::vector<T>& records, Pcg32& rng, uint32_t one_in) {
  constexpr float kBad[] = {kNan, kInf, -kInf, 0};
  for (T& record : records)
    if (rng.below(one_in) == 0)
      std::memcpy(reinterpret_cast<std::byte*>(&record) + 4 * rng.below(sizeof(T) / 4), &kBad[rng.below(4)], 4);
}

// Numbers that are none, views past the end, tiles past the atlas.
void spoil(Setup& s, Pcg32& rng) {
  break_some(s.receivers, rng, 8);
  break_some(s.lights, rng, 3);
  break_some(s.atlas.views, rng, 4);
  for (float& depth : s.atlas.depths)
    if (rng.below(32) == 0) depth = rng.below(2) ? kNan : kInf;
  for (LightRecord& light : s.lights)
    if (rng.below(4) == 0) light.views = rng.below(3) ? rng.below(12) : rng.next();
  for (ShadowView& view : s.atlas.views)
    if (rng.below(8) == 0) view.tile.side = rng.below(2) ? rng.next() : rng.below(kCell * kCells + 2);
}

Case random_case(Random& r) {
  const Extent extent = random_extent(r, 32);
  Setup s = {shadowing::Atlas({kCell * kCells, kCell * kCells})};
  const uint32_t lights = 1 + r.rng.below(kCells);
  for (uint32_t i = 0; i < lights; ++i) add_random_light(s, r.rng, i);
  const auto casters = random_casters(r.rng);
  if (r.branch({{"drawn_maps", 0.7}, {"noisy_maps", 0.3}}) != 0)
    add_noise(s.atlas, r.rng);
  else
    for (uint32_t view = 0; view < s.atlas.views.size(); ++view)
      for (const Caster& c : casters) s.atlas.draw(view, c);
  add_random_receivers(s, r.rng, casters, pixel_count(extent));
  if (r.branch({{"whole", 0.8}, {"spoilt", 0.2}}) != 0) spoil(s, r.rng);
  return case_of(s, extent);
}

// Half of the receivers, of each half.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  const auto receivers = c.input<Receiver>("receivers");
  const size_t half = receivers.size() / 2;
  if (half == 0) return found;
  for (const size_t first : {size_t{0}, receivers.size() - half}) {
    Case cut = c;
    cut.extent = {static_cast<uint32_t>(half), 1};
    auto params = c.params<LookupParams>();
    params.receivers = static_cast<uint>(half);
    cut.set_params(params);
    cut.set_input("receivers", receivers.subspan(first, half));
    found.push_back(cut);
  }
  return found;
}

}  // namespace

Case to_case(const Setup& s) { return case_of(s, {static_cast<uint32_t>(s.receivers.size()), 1}); }

Case typical(Extent extent) {
  constexpr uint32_t kSide = 512;
  Setup s = {shadowing::Atlas({4 * kSide, kSide + kSide / 2})};
  const std::vector<Caster> casters = {{{0, -1.6, 0}, {0, 1, 0}},          {{0, 0, -9}, {0, 0, 1}},
                                       {{-1.5, -0.4, -4}, {0.3, 1, 0}, 1}, {{1, 0.2, -5}, {0, 0.6, 1}, 0.8},
                                       {{0, 1, -6}, {0.2, 1, 0.1}, 0.7},   {{2.5, -1, -3.5}, {1, 0.2, 0}, 0.5}};
  const dvec3 lamp = {0.5, 1.8, -4}, sun = glm::normalize(dvec3(-0.4, -1, -0.5));
  s.add_light(kLightSpot, {2, 2.5, -2}, {-0.4, -0.9, -0.6},
              s.atlas.add_spot({0, 0, kSide}, {2, 2.5, -2}, {-0.4, -0.9, -0.6}, 0.9, 0.1, 15), 1);
  for (uint32_t i = 0; i < 3; ++i)
    s.atlas.add_cascade({(i + 1) * kSide, 0, kSide}, dvec3(0, 0, -2.5) * std::exp2(i), sun, 3 * std::exp2(i), 20, 15);
  s.add_light(kLightDirectional, {}, sun, 1, 3);
  s.add_light(kLightPoint, lamp, {}, s.atlas.add_cube({0, kSide, kSide / 2}, lamp, 0.1, 15), kCubeFaces);
  for (uint32_t view = 0; view < s.atlas.views.size(); ++view)
    for (const Caster& c : casters) s.atlas.draw(view, c);
  // Seen from the eye, 90 degrees across; a wave of 64 has one light.
  const double side = std::max(extent.width, extent.height);
  for (uint32_t y = 0; y < extent.height; ++y)
    for (uint32_t x = 0; x < extent.width; ++x) {
      const dvec3 ray = {(2 * x + 1.0 - extent.width) / side, -(2 * y + 1.0 - extent.height) / side, -1};
      double nearest = 30;
      dvec3 normal = {};
      for (const Caster& c : casters) {
        const double t = glm::dot(c.normal, c.centre) / glm::dot(c.normal, ray);
        if (t > 0 && t < nearest && glm::length(t * ray - c.centre) <= c.radius)
          nearest = t, normal = glm::normalize(c.normal);
      }
      const auto light = static_cast<uint32_t>(s.receivers.size() / 64 % 3);
      s.receive(light, nearest * ray, normal, shadowing::dither_of(x, y, 0));
    }
  return case_of(s, extent);
}

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"drawn_maps", "noisy_maps", "whole", "spoilt"}) branches.emplace_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller};
}

}  // namespace assay::shadow_lookup
