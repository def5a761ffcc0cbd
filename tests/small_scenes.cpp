#include "tests/small_scenes.h"

#include <cmath>
#include <stdexcept>

#include "tests/glb.h"

namespace assay::tests {
namespace {

// Smooth and colourful, with two quarters cut out where asked for.
scene::Image ramp(const std::string& name, uint32_t side, bool holes) {
  scene::Image image = {name, side, side, {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const bool hole = holes && (x / 16 + y / 16) % 2 == 0;
      const uint32_t texel[] = {60 + 180 * x / side, 40 + 200 * y / side, 120 + 60 * (x + y) / side, hole ? 0u : 255u};
      for (const uint32_t c : texel) image.rgba.push_back(static_cast<uint8_t>(c));
    }
  return image;
}

// Waves along u: x of the normal swings, y is a constant slant.
scene::Image bumps(uint32_t side) {
  scene::Image image = {"bumps", side, side, {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const double nx = 0.5 * std::sin(6.283185307 * (x + 0.5) / side), ny = 0.2;
      const double n[] = {nx, ny, std::sqrt(1 - nx * nx - ny * ny)};
      for (const double c : n) image.rgba.push_back(static_cast<uint8_t>(std::lround((c * 0.5 + 0.5) * 255)));
      image.rgba.push_back(255);
    }
  return image;
}

Json& primitive(Glb& g) { return g.doc["meshes"][0]["primitives"][0]; }

void add_view(scene::Scene& s, bool behind) {
  const double side = behind ? -1 : 1;
  s.cameras = {scene::look_at({10.8, 0.7, side * 2.8}, {10, 0, 0}, 0.785398)};
  s.lights = {{.kind = scene::LightKind::spot,
               .position = {9.2, 1.5, side * 2},
               .direction = normalize(glm::vec3(0.8f, -1.5f, static_cast<float>(side) * -2)),
               .colour = {1, 0.8f, 0.6f},
               .intensity = 20,
               .range = 9,
               .inner_rad = 0.2f,
               .outer_rad = 0.6f},
              {.kind = scene::LightKind::point, .position = {11, -0.5, side * 1.2}, .intensity = 3, .range = 4}};
}

}  // namespace

const std::vector<std::string>& small_scene_names() {
  static const std::vector<std::string> names = {"masked", "double_sided", "tangentless", "uvless", "textureless"};
  return names;
}

scene::Scene small_scene(const std::string& name) {
  Glb g = quad();
  if (name == "tangentless")
    primitive(g)["attributes"]["TEXCOORD_0"] = g.add<float>({1, 1, 0, 1, 0, 0, 1, 0}, 5126, "VEC2", 2);
  if (name == "uvless") primitive(g)["attributes"].erase("TEXCOORD_0");
  scene::Scene s = load(g);
  s.name = name;
  s.images = {ramp("ramp", 32, name == "masked")};
  scene::Material m = {.name = name, .metallic = 0.25f, .roughness = 0.5f, .base_image = 0};
  if (name == "masked") {
    m.alpha = scene::AlphaMode::masked;
  } else if (name == "double_sided") {
    m.double_sided = true;
  } else if (name == "tangentless") {
    s.images.push_back(bumps(64));
    m.normal_image = 1;
    m.normal_scale = 0.8f;
    m.metallic_roughness_image = m.occlusion_image = 0;
    m.occlusion_strength = 0.5f;
  } else if (name == "textureless") {
    m.base_image = scene::kNone;
    m.base_colour = {0.2f, 0.4f, 0.6f, 1};
    m.emissive = {0.5f, 0.25f, 2};
  } else if (name != "uvless") {
    throw std::logic_error("no small scene " + name);
  }
  s.materials[0] = m;
  add_view(s, name == "double_sided");
  return s;
}

}  // namespace assay::tests
