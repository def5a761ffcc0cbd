#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "kernels/visibility/inputs.h"

namespace assay::visibility {

namespace {

constexpr double kTurn = 6.283185307179586;

// Counter-clockwise from outside; `u` runs around, `v` from the south pole to the north.
Mesh ball(uint32_t around, uint32_t up) {
  Mesh m;
  add_grid(m, around, up, [](float u, float v) {
    const double longitude = kTurn * u, latitude = kTurn / 4 * (2 * v - 1),
                 r = 1 + 0.1 * std::sin(5 * longitude) * std::cos(3 * latitude);
    return vec3(r * std::cos(latitude) * std::sin(longitude), r * std::sin(latitude),
                r * std::cos(latitude) * std::cos(longitude));
  });
  return m;
}

// Leaves: quads in a cube, each turned its own way.
Mesh cards(uint32_t count, Pcg32& rng) {
  Mesh m;
  for (uint32_t i = 0; i < count; ++i) {
    const vec3 centre(rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1));
    const double turn = rng.range(0, kTurn), lean = rng.range(-0.6, 0.6);
    const vec3 right = vec3(0.12 * std::cos(turn), 0, 0.12 * std::sin(turn)), up = vec3(0.12 * lean, 0.12, 0);
    const uint32_t first = static_cast<uint32_t>(m.positions.size());
    for (const vec2 uv : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)})
      add_vertex(m, centre + (uv.x - 0.5f) * right + (uv.y - 0.5f) * up, uv);
    add_triangle(m, first, first + 1, first + 2);
    add_triangle(m, first, first + 2, first + 3);
  }
  return m;
}

uint32_t add_leaf(SceneBuilder& scene) {
  return scene.add_texture(
      alpha_texture(64, 64, 1, Format::rgba8_srgb, [](uint32_t x, uint32_t y, uint32_t) -> uint32_t {
        const double dx = (x - 31.5) / 32, dy = (y - 31.5) / 32;
        return dx * dx * 2 + dy * dy < 0.8 ? 255 : 0;
      }));
}

void add_room(SceneBuilder& scene) {
  Mesh floor, wall;
  add_grid(floor, 64, 64, [](float u, float v) { return vec3(60 * u - 30, -1.6, -60 * v); });
  add_grid(wall, 96, 48, [](float u, float v) {
    return vec3(120 * u - 60, 60 * v - 20, -55 - 3 * std::sin(20 * u) * std::cos(11 * v));
  });
  scene.add(floor, {});
  scene.add(wall, {});
}

}  // namespace

Case typical(Extent e) {
  SceneBuilder scene(e);
  Pcg32 rng(7);
  add_room(scene);
  Look instanced;
  instanced.instanced = true;
  for (const bool mirrored : {false, true}) {
    std::vector<glm::dmat4> places;
    for (int i = 0; i < 24; ++i) {
      const glm::dvec3 at(rng.range(-20, 20), rng.range(-1, 6), -rng.range(3, 45));
      glm::dmat4 place = glm::rotate(glm::translate(glm::dmat4(1), at), rng.range(0, kTurn), glm::dvec3(0, 1, 0));
      place = glm::scale(place, glm::dvec3(rng.range(0.4, 1.2)));
      places.push_back(mirrored ? glm::scale(place, glm::dvec3(-1, 1, 1)) : place);
    }
    scene.add(ball(32, 20), instanced, places);
  }
  Look leaves;
  leaves.material = {vec4(1), texture_name(add_leaf(scene), 0), 0.5f, kMaterialMasked | kMaterialDoubleSided, 0};
  leaves.instanced = true;
  std::vector<glm::dmat4> trees(12);
  for (glm::dmat4& tree : trees)
    tree = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(rng.range(-12, 12), rng.range(0, 2), -rng.range(4, 25))),
                      glm::dvec3(2));
  scene.add(cards(200, rng), leaves, trees);
  return scene.finish("typical");
}

}  // namespace assay::visibility
