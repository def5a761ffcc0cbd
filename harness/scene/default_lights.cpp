// The 300 lights of `default`, and the scene itself.
#include <cmath>

#include "harness/scene/default_scene.h"

namespace assay::scene::builtin {
namespace {

constexpr uint32_t kCandlesABay = 20, kSpotsABay = 12, kPortalSpots = 11;
constexpr uint32_t kCastersABay = 4;  // of the spots

// Round the hue circle, never darker than a third.
glm::vec3 hue(double turn) {
  const auto channel = [turn](double shift) {
    return static_cast<float>(0.65 + 0.35 * std::cos((turn + shift) * kTau));
  };
  return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

void add_points(Scene& s, uint32_t bay) {
  const double z = middle(bay);
  for (const double sign : {-1.0, 1.0}) {
    s.lights.push_back({.kind = LightKind::point,
                        .position = {sign * 5.4, 1.6, z + sign},
                        .colour = hue(0.17 * bay),
                        .intensity = 25,
                        .range = 7});
    s.lights.push_back({.kind = LightKind::point,
                        .position = {sign * 1.9, 4.7, z - 2.5},
                        .colour = {1, 0.85f, 0.6f},
                        .intensity = 30,
                        .range = 9,
                        .casts_shadows = bay + 2 >= kBays});
  }
  for (uint32_t i = 0; i < kCandlesABay; ++i) {  // two rows along the nave and the walls
    const uint32_t pair = i / 2;
    s.lights.push_back({.kind = LightKind::point,
                        .position = {(i % 2 ? 1 : -1) * (i % 4 < 2 ? 1.3 : 9.3), 0.35 + 0.05 * (i % 3),
                                     z + kBayLength_m * (pair / 10.0 - 0.45)},
                        .colour = hue(0.07 * i + 0.2 * bay),
                        .intensity = 1.5f,
                        .range = 2.5f,
                        .motion = {.reach = {0.04, 0.02, 0.03}, .period_s = 0.7 + 0.1 * (i % 5)}});
  }
}

// From under the vault: onto the capitals, the banners and the floor.
void add_spots(Scene& s, uint32_t bay) {
  for (uint32_t i = 0; i < kSpotsABay; ++i) {
    const uint32_t pair = i / 2;
    const double sign = i % 2 ? 1 : -1, across = 1.5 + 1.3 * pair;
    const glm::dvec3 from(sign * across, 8.6, middle(bay) + 3 - pair),
        to(sign * (across + 0.8), 0, middle(bay) - 2 + 0.7 * i / 2.0);
    s.lights.push_back({.kind = LightKind::spot,
                        .position = from,
                        .direction = glm::vec3(normalize(to - from)),
                        .colour = hue(0.31 * i + 0.11 * bay),
                        .intensity = 60,
                        .range = 12,
                        .inner_rad = 0.15f,
                        .outer_rad = 0.25f + 0.02f * static_cast<float>(i),
                        .casts_shadows = i < kCastersABay});
  }
}

}  // namespace

void add_default_lights(Scene& s) {
  s.lights.push_back({.kind = LightKind::directional,
                      .direction = normalize(glm::vec3(0.35f, -0.8f, -0.5f)),
                      .colour = {1, 0.96f, 0.9f},
                      .intensity = 0.6f});
  for (uint32_t bay = 0; bay < kBays; ++bay) {
    add_points(s, bay);
    add_spots(s, bay);
  }
  for (uint32_t i = 0; i < kPortalSpots; ++i)  // a fan out of the portal
    s.lights.push_back({.kind = LightKind::spot,
                        .position = {0.5 * i - 2.5, 4, -27.5},
                        .direction = normalize(glm::vec3(0.12f * (static_cast<float>(i) - 5), -0.25f, 1)),
                        .colour = hue(0.6 + 0.03 * i),
                        .intensity = 120,
                        .range = 25,
                        .inner_rad = 0.05f,
                        .outer_rad = 0.2f,
                        .casts_shadows = i % 5 == 0,
                        .motion = {.turn_rad = 0.3, .period_s = 5}});
}

}  // namespace assay::scene::builtin

namespace assay::scene {

Scene default_scene() {
  Scene s;
  s.name = "default";
  const builtin::Palette palette = builtin::add_default_materials(s, builtin::paint_looks(s));
  builtin::add_building(s, palette);
  builtin::add_furniture(s, palette);
  builtin::add_default_lights(s);
  builtin::add_default_decals(s);
  builtin::add_default_particles(s);
  s.cameras = {look_at({0.5, 1.9, 27}, {-0.1, 2.3, 0}, 0.872665)};
  s.cameras[0].name = "nave";
  return s;
}

}  // namespace assay::scene
