// An atlas of 64 spots' tiles, all drawn anew: the same room from as many places.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "kernels/shadow_atlas/builder.h"

namespace assay::shadow_atlas {

using namespace raster;

namespace {

constexpr double kTurn = 6.283185307179586;
constexpr uint32_t kTilesAside = 8;

Mesh ball() {
  Mesh m;
  add_grid(m, 14, 8, [](float u, float v) {
    const double longitude = kTurn * u, latitude = kTurn / 4 * (2 * v - 1);
    return vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude));
  });
  return m;
}

// Leaves: quads in a cube, each turned its own way.
Mesh cards(uint32_t count, Pcg32& rng) {
  Mesh m;
  for (uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 centre(rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1));
    const double turn = rng.range(0, kTurn);
    const glm::dvec3 right(0.3 * std::cos(turn), 0, 0.3 * std::sin(turn)), up(0, 0.3, 0);
    add_grid(m, 1, 1, [&](float u, float v) { return vec3(centre + (u - 0.5) * 2.0 * right + (v - 0.5) * 2.0 * up); });
  }
  return m;
}

glm::dmat4 at(double x, double y, double z, double size) {
  return glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(x, y, z)), glm::dvec3(size));
}

}  // namespace

Case typical(Extent e) {
  Builder b(e.width, e.height);
  Pcg32 rng(11);
  const uint32_t side = std::min(e.width, e.height) / kTilesAside;
  std::vector<glm::dmat4> views;  // from the room's coordinates to a light's
  for (uint32_t i = 0; i < kTilesAside * kTilesAside; ++i) {
    b.add_both({i % kTilesAside * side, i / kTilesAside * side, side});
    const glm::dvec3 eye(rng.range(-8, 8), rng.range(3, 5), rng.range(-8, 8));
    views.push_back(glm::lookAt(eye, glm::dvec3(rng.range(-4, 4), 0, rng.range(-4, 4)), glm::dvec3(0, 0, 1)));
  }
  const LightView light = {.half_width = 0.8};
  const auto add = [&](const Mesh& mesh, const Look& look, const std::vector<glm::dmat4>& places) {
    for (const glm::dmat4& place : places) {
      std::vector<Placed> placed;
      for (uint32_t i = 0; i < views.size(); ++i) placed.push_back({i, light, views[i] * place});
      b.add(mesh, look, placed);
    }
  };
  Mesh floor;
  add_grid(floor, 12, 12, [](float u, float v) { return vec3(24 * u - 12, 0, 12 - 24 * v); });
  add(floor, {}, {glm::dmat4(1)});
  std::vector<glm::dmat4> still, moving;
  for (uint32_t i = 0; i < 10; ++i)
    (i < 8 ? still : moving).push_back(at(rng.range(-8, 8), rng.range(0.5, 2), rng.range(-8, 8), rng.range(0.4, 1)));
  add(ball(), {}, still);
  add(ball(), {.moving = true}, moving);
  const uint32_t leaf =
      b.add_texture(alpha_texture(64, 64, 1, Format::rgba8_srgb, [](uint32_t x, uint32_t y, uint32_t) -> uint32_t {
        const double dx = (x - 31.5) / 32, dy = (y - 31.5) / 32;
        return dx * dx * 2 + dy * dy < 0.8 ? 255 : 0;
      }));
  add(cards(40, rng), masked_look(1, 0.5f, texture_name(leaf, 0)), {at(2, 1, 3, 1), at(-5, 1, -2, 1)});
  Case c = b.finish();
  c.name = "typical";
  return c;
}

}  // namespace assay::shadow_atlas
