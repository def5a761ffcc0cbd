// Scenes made by code, the same on every machine: `bare` and `small`.
#include <cmath>

#include "harness/scene/builtin.h"

namespace assay::scene {

using namespace builtin;

namespace {

// ---- Textures of `small` -------------------------------------------------------------------------------------------

glm::vec4 tiles(float u, float v) {
  const bool odd = (static_cast<int>(u * 4) + static_cast<int>(v * 4)) % 2;
  const float joint = std::fmin(std::fmod(u * 4, 1.0f), std::fmod(v * 4, 1.0f)) < 0.06f ? 0.6f : 1.0f;
  return glm::vec4(glm::vec3(odd ? 0.72f : 0.55f, odd ? 0.68f : 0.5f, odd ? 0.6f : 0.46f) * joint, 1);
}
glm::vec4 weave(float u, float v) {
  const float stripe = std::fmod(u * 6, 1.0f) < 0.5f ? 1.0f : 0.75f, border = v < 0.08f || v > 0.92f ? 0.5f : 1.0f;
  return {0.75f * stripe * border, 0.15f * stripe, 0.12f * stripe, 1};
}

// ---- Shapes of `small` ---------------------------------------------------------------------------------------------

glm::dvec3 fluted_column(double u, double v) {
  const double foot = std::exp(-v * 18) + std::exp((v - 1) * 18);  // wider at both ends
  const double radius = 0.32 - 0.05 * v + 0.12 * foot + 0.018 * std::cos(u * kTau * 16) * (1 - std::min(1.0, foot * 2));
  return {radius * std::sin(u * kTau), 4.2 * v, radius * std::cos(u * kTau)};
}
// A tube along a rising spiral: no mirror image of itself.
glm::dvec3 spiral(double u, double v) {
  const auto centre = [](double t) {
    const double r = 0.45 - 0.3 * t;
    return glm::dvec3(r * std::cos(t * kTau * 2), 0.1 + 1.5 * t, r * std::sin(t * kTau * 2));
  };
  const glm::dvec3 along = normalize(centre(v + 1e-3) - centre(v - 1e-3));
  const glm::dvec3 side = normalize(cross(along, glm::dvec3(0, 1, 0))), up = cross(side, along);
  const double radius = 0.11 - 0.06 * v;
  return centre(v) + radius * (side * std::cos(u * kTau) - up * std::sin(u * kTau));
}
glm::dvec3 banner(double u, double v) { return {u - 0.5, 2.2 * v, 0.1 * std::sin(u * 9 + v * 3) * (1.2 - v)}; }

void add_hall(Scene& s) {
  const uint32_t floor = add_material(
      s, {.name = "floor", .metallic = 0, .roughness = 0.7f, .base_image = add_image(s, "floor tiles", 128, tiles)});
  const uint32_t plaster = add_material(s, {.name = "plaster", .base_colour = {0.75f, 0.7f, 0.62f, 1}, .metallic = 0});
  const uint32_t marble =
      add_material(s, {.name = "marble", .base_colour = {0.85f, 0.83f, 0.8f, 1}, .metallic = 0, .roughness = 0.3f});
  const uint32_t water = add_material(s, {.name = "puddle",
                                          .base_colour = {0.1f, 0.13f, 0.15f, 1},
                                          .metallic = 0,
                                          .roughness = 0.05f,
                                          .features = kFeaturePuddles | kFeatureWetnessDrops});
  place(s,
        add_patch_mesh(s, "floor", floor, 16, 16, {8, 8},
                       [](double u, double v) { return glm::dvec3(16 * u - 8, 0, 8 - 16 * v); }),
        {0, 0, 0});
  place(s,
        add_patch_mesh(s, "wall", plaster, 8, 4, {4, 2},
                       [](double u, double v) { return glm::dvec3(16 * u - 8, 5 * v, 0); }),
        {0, 0, -8});
  const uint32_t column = add_patch_mesh(s, "column", marble, 96, 24, {2, 6}, fluted_column);
  for (int i = 0; i < 4; ++i)
    for (const double side : {-3.0, 3.0}) place(s, column, {side, 0, -6.0 + 3.2 * i}, 0.3 * i);
  place(s,
        add_patch_mesh(s, "puddle", water, 24, 8, {1, 1},
                       [](double u, double v) {
                         const double radius = v * (0.8 + 0.2 * std::cos(3 * u * kTau)) + 1e-3;
                         return glm::dvec3(-radius * std::sin(u * kTau), 0.01, radius * std::cos(u * kTau) * 0.7);
                       }),
        {0.6, 0, 1.2});
}

void add_things(Scene& s) {
  const uint32_t bronze =
      add_material(s, {.name = "bronze", .base_colour = {0.7f, 0.45f, 0.2f, 1}, .metallic = 1, .roughness = 0.25f});
  const uint32_t lamp = add_material(s, {.name = "lamp", .metallic = 0, .emissive = {4, 3.2f, 2}});
  const uint32_t cloth = add_material(s, {.name = "banner",
                                          .metallic = 0,
                                          .roughness = 0.9f,
                                          .base_image = add_image(s, "weave", 64, weave),
                                          .double_sided = true,
                                          .features = kFeatureCloth});
  const uint32_t bars = add_material(s, {.name = "grille",
                                         .metallic = 0,
                                         .roughness = 0.5f,
                                         .base_image = add_image(s, "grille", 64, grille),
                                         .alpha = AlphaMode::masked});
  const uint32_t spirals = add_patch_mesh(s, "spiral", bronze, 16, 96, {1, 8}, spiral);
  place(s, spirals, {-1.2, 0, -2.5});
  place(s, spirals, {1.4, 0, -2.5}, 0.2, {-1, 1, 1});  // mirrored
  place(s, add_patch_mesh(s, "lamp", lamp, 24, 16, {1, 1}, [](double u, double v) { return sphere(u, v) * 0.18; }),
        {0, 3.2, -3});
  const uint32_t flag = add_patch_mesh(s, "banner", cloth, 20, 24, {1, 1}, banner);
  place(s, flag, {-1.6, 1.6, -5});
  place(s, flag, {1.6, 1.6, -5}, 2.6);
  const uint32_t screen = add_patch_mesh(s, "grille", bars, 2, 2, {1, 1},
                                         [](double u, double v) { return glm::dvec3(1.6 * u - 0.8, 1.8 * v, 0); });
  place(s, screen, {-4.6, 0, 0.5}, 0.5);
  place(s, screen, {4.6, 0, 0.5}, -0.5, {-1, 1, 1});  // mirrored
}

void add_foliage(Scene& s) {
  const uint32_t leaf = add_material(s, {.name = "foliage",
                                         .metallic = 0,
                                         .roughness = 0.6f,
                                         .base_image = add_image(s, "leaves", 128, leaves),
                                         .alpha = AlphaMode::masked,
                                         .double_sided = true});
  Mesh cards;  // three crossed quads
  cards.name = "plant";
  for (int i = 0; i < 3; ++i) {
    const double angle = i * kTau / 6;
    append_patch(cards, 2, 3, {1, 1}, [angle](double u, double v) {
      return glm::dvec3((u - 0.5) * std::cos(angle), 1.1 * v, (u - 0.5) * std::sin(angle));
    });
  }
  const uint32_t plant = add_mesh(s, std::move(cards), leaf);
  for (int i = 0; i < 24; ++i) {  // a low-discrepancy scatter beside the columns
    const double a = std::fmod(i * 0.7548776662, 1.0), b = std::fmod(i * 0.5698402910, 1.0), side = i % 2 ? 1 : -1;
    place(s, plant, {side * (3.6 + 2.8 * a), 0, -7 + 9 * b}, 5.1 * a, glm::dvec3(0.7 + 0.6 * b));
  }
}

// A spill on the floor, a sheet on the wall, a chipped and a painted column, one of each under a receiver.
void add_decals(Scene& s) {
  const uint32_t spill = add_image(s, "spill", 64, [](float u, float v) {
    const float inside = 0.42f - std::hypot(u - 0.5f, v - 0.5f) + 0.04f * std::cos(std::atan2(v - 0.5f, u - 0.5f) * 5);
    return glm::vec4(0.2f, 0.12f, 0.1f, inside * 12);
  });
  const uint32_t sheet = add_image(s, "sheet", 64, [](float u, float v) {
    const bool written = std::fmod(v, 0.125f) < 0.05f && u > 0.15f && u < 0.85f && v > 0.15f && v < 0.85f;
    return glm::vec4(glm::vec3(written ? 0.15f : 0.9f), 1);
  });
  const uint32_t chips = add_image(s, "chips", 64, [](float u, float v) {
    const float x = std::cos(u * 25), y = std::sin(v * 19);
    return glm::vec4(normalize(glm::vec3(0.5f * x, 0.5f * y, 1)) * 0.5f + 0.5f, 1);
  });
  const glm::dquat level = glm::angleAxis(-kTau / 4, glm::dvec3(1, 0, 0));  // z of the box upwards
  uint32_t column = 0;
  while (s.meshes[s.instances[column].mesh].name != "column") ++column;
  s.decals = {{.centre = {-0.9, 0, 2.6},
               .orientation = level,
               .half_extents = {0.9, 0.7, 0.1},
               .colour_image = spill,
               .roughness = 0.1f,
               .weights = {0.9f, 0, 1}},
              {.centre = {0.3, 2.2, -8}, .half_extents = {0.7, 0.9, 0.1}, .colour_image = sheet, .roughness = 0.6f},
              {.centre = {0, 2, 0.35},
               .half_extents = {0.3, 0.4, 0.2},
               .normal_image = chips,
               .weights = {0, 1, 0},
               .normal_mode = kNormalReoriented,
               .receiver = column + 4},
              {.centre = {0, 1.4, 0.35},
               .half_extents = {0.3, 0.3, 0.2},
               .colour = {0.6f, 0.05f, 0.03f, 0.8f},
               .fade_distance = 30,
               .receiver = column + 5}};
}

}  // namespace

Scene bare() {
  Scene s;
  s.name = "bare";
  add_material(s, {.name = "plain", .base_colour = {0.8f, 0.3f, 0.2f, 1}, .metallic = 0});
  Mesh triangle;
  triangle.name = "triangle";
  triangle.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1.6f, 0}};
  triangle.attributes.assign(3, {{0, 0, 1}, {1, 0, 0, 1}, {0, 0}});
  triangle.indices = {0, 1, 2};
  place(s, add_mesh(s, std::move(triangle), 0), {0, 0, 0});
  s.cameras = {look_at({0, 0.8, 3}, {0, 0.8, 0}, 0.785398)};
  s.cameras[0].name = "front";
  return s;
}

Scene small() {
  Scene s;
  s.name = "small";
  add_hall(s);
  add_things(s);
  add_foliage(s);
  add_decals(s);
  s.lights = {
      {.kind = LightKind::directional,
       .direction = normalize(glm::vec3(0.4f, -1, -0.3f)),
       .colour = {1, 0.95f, 0.9f},
       .intensity = 3,
       .casts_shadows = true},
      {.kind = LightKind::point, .position = {0, 3.2, -3}, .colour = {1, 0.8f, 0.5f}, .intensity = 60, .range = 8},
      {.kind = LightKind::spot,
       .position = {-4, 4.5, 3},
       .direction = normalize(glm::vec3(0.5f, -0.7f, -0.7f)),
       .intensity = 200,
       .range = 12,
       .inner_rad = 0.3f,
       .outer_rad = 0.5f,
       .casts_shadows = true},
  };
  const Motion lamp = {.reach = {0.8, 0, 0.4}, .period_s = 3};
  s.lights[1].motion = lamp;
  s.lights[2].motion = {.turn_rad = 0.3, .period_s = 4};
  set_motion(s, "lamp", lamp);
  set_motion(s, "banner", {.reach = {0, 0, 0.15}, .turn_rad = 0.2, .period_s = 2});
  set_motion(s, "spiral", {.turn_rad = 1, .period_s = 6});
  for (const Decal& d : s.decals)
    if (d.receiver != kNone) s.instances[d.receiver].motion = {.turn_rad = 0.3, .period_s = 3};
  add_particles(s, {.position = {-1.4, 0.5, 0.5}, .count = 24, .radius = 0.25f, .opacity = 0.3f});
  add_particles(s, {.kind = EmitterKind::dust,
                    .position = {0, 2, 0},
                    .half_extents = {2.5, 1.2, 3},
                    .count = 24,
                    .radius = 0.03f,
                    .opacity = 0.5f});
  s.cameras = {look_at({0.6, 2.1, 7.2}, {0, 1.5, -2}, 0.785398)};
  s.cameras[0].name = "hall";
  return s;
}

}  // namespace assay::scene
