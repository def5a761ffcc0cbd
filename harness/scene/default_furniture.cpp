// What stands and hangs in the hall of `default`.
#include <cmath>

#include "harness/scene/default_scene.h"

namespace assay::scene::builtin {
namespace {

// The i-th point of a low-discrepancy sequence in the unit square.
glm::dvec2 scattered(uint32_t i) {
  return {std::fmod(i * 0.7548776662466927, 1.0), std::fmod(i * 0.5698402909980532, 1.0)};
}

void add_banners(Scene& s, const Palette& palette) {
  for (uint32_t b = 0; b < kBays; ++b)
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t banner = add_patch_mesh(
          s, "banner", palette(kShaderCloth, 3 + 2 * b + side), 24, 32, {1.5f, 3}, [](double u, double v) {
            return glm::dvec3(1.3 * (u - 0.5), 2.5 * v, 0.12 * std::sin(u * 8 + v * 4) * (1.1 - v));
          });
      place(s, banner, {side ? 2.9 : -2.9, 4.3, middle(b)}, side ? -0.25 : 0.25);
    }
}

// Across the aisles, every other one mirrored, so that single-sided sheets are seen in both windings.
void add_fences(Scene& s, const Palette& palette) {
  for (uint32_t b = 0; b < kBays; ++b)
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t fence = add_patch_mesh(s, "fence", palette(kShaderMasked, b + side), 2, 2, {3, 1.5f},
                                            [](double u, double v) { return glm::dvec3(4.8 * (u - 0.5), 2.8 * v, 0); });
      place(s, fence, {side ? 7.5 : -7.5, 0, middle(b) - 2.8}, 0, {side ? -1.0 : 1.0, 1, 1});
    }
}

// Four tapering faces and a slanted top.
uint32_t add_obelisk(Scene& s, uint32_t material) {
  Mesh mesh;
  mesh.name = "obelisk";
  for (int face = 0; face < 4; ++face) {
    const double turn = face * kTau / 4;
    append_patch(mesh, 1, 4, {1, 3}, [turn](double u, double v) {
      const double half = 0.5 - 0.15 * v, x = (2 * u - 1) * half;
      return glm::dvec3(x * std::cos(turn) + half * std::sin(turn), 2.9 * v,
                        half * std::cos(turn) - x * std::sin(turn));
    });
  }
  append_patch(mesh, 1, 1, {1, 1},
               [](double u, double v) { return glm::dvec3(0.7 * (u - 0.5), 2.9 + 0.001 * v, 0.7 * (0.5 - v)); });
  return add_mesh(s, std::move(mesh), material);
}

void add_glowing(Scene& s, const Palette& palette) {
  for (uint32_t b = 0; b < kBays; ++b) {
    const uint32_t obelisk = add_obelisk(s, palette(kShaderEmissiveDetail, b));
    for (const double sign : {-1.0, 1.0}) place(s, obelisk, {sign * 6.3, 0, middle(b) + sign}, 0.5 + b);
    const uint32_t lantern = add_patch_mesh(s, "lantern", palette(kShaderEmissiveDetail, b + 3), 24, 16, {2, 1},
                                            [](double u, double v) { return sphere(u, v) * 0.32; });
    for (const double sign : {-1.0, 1.0}) place(s, lantern, {sign * 1.9, 5.2, middle(b) - 2.5}, b);
  }
  const uint32_t portal = add_patch_mesh(s, "portal", palette(kShaderEmissiveDetail, 1), 1, 1, {3, 3},
                                         [](double u, double v) { return glm::dvec3(6 * (u - 0.5), 7 * v, 0); });
  place(s, portal, {0, 0.5, -27.9});
}

// Lumps of flesh: a sphere that swells and folds.
void add_growths(Scene& s, const Palette& palette) {
  for (uint32_t i = 0; i < palette.of_class[kShaderSkin].size(); ++i) {
    const uint32_t growth =
        add_patch_mesh(s, "growth", palette(kShaderSkin, i), 64, 40, {3, 2}, [i](double u, double v) {
          const double fold = std::sin(u * kTau * 3 + v * 9 + i) * std::sin(v * 3.1416) * 0.12;
          const double swell = 0.1 * std::sin(u * kTau * 5) * std::sin(v * 3.1416 * 4);
          return sphere(u, v) * (0.9 + fold + swell * std::sin(v * 3.1416)) * glm::dvec3(1, 1.2, 1);
        });
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t n = i + 5 * k;
      const double sign = n % 2 ? 1 : -1;
      place(s, growth, {sign * (3.1 - 0.4 * scattered(n).x), 0.45, middle(1) + 2 - 2.9 * n}, 1.7 * n,
            glm::dvec3(0.75 + 0.35 * scattered(n).y));
    }
  }
}

// Cards in a ball: each stands on the ball's middle and leans outwards.
uint32_t add_bush(Scene& s, uint32_t material) {
  Mesh mesh;
  mesh.name = "bush";
  for (uint32_t i = 0; i < 20; ++i) {
    const double turn = i * 2.399963, lean = 0.15 + 1.1 * scattered(i).x, size = 0.7 + 0.4 * scattered(i).y;
    const glm::dvec3 right(std::cos(turn), 0, -std::sin(turn)),
        up(std::sin(lean) * std::sin(turn), std::cos(lean), std::sin(lean) * std::cos(turn)), out = cross(right, up);
    append_patch(mesh, 2, 3, {1, 1},
                 [=](double u, double v) { return (right * (u - 0.5) + up * v - out * (0.25 * v * v)) * size; });
  }
  return add_mesh(s, std::move(mesh), material);
}

void add_plants(Scene& s, const Palette& palette) {
  Mesh box;
  box.name = "planter";
  for (int face = 0; face < 4; ++face) {
    const double turn = face * kTau / 4;
    append_patch(box, 1, 1, {1, 0.5f}, [turn](double u, double v) {
      const double half = 0.55 + 0.08 * v, x = (2 * u - 1) * half;
      return glm::dvec3(x * std::cos(turn) + half * std::sin(turn), 0.5 * v,
                        half * std::cos(turn) - x * std::sin(turn));
    });
  }
  const uint32_t planter = add_mesh(s, std::move(box), palette(kShaderOpaque, 12));
  std::vector<uint32_t> bushes;
  for (const uint32_t m : palette.of_class[kShaderFoliage]) bushes.push_back(add_bush(s, m));
  for (uint32_t i = 0; i < 6 * kBays; ++i) {
    const double sign = i % 2 ? 1 : -1, z = 25 - 1.1 * i;
    const glm::dvec3 at(sign * (4.1 + 0.2 * scattered(i).x), 0, z);
    place(s, planter, at, 0.1 * i, glm::dvec3(0.8));
    const double size = 0.9 + 0.4 * scattered(i).y;
    place(s, bushes[i % bushes.size()], at + glm::dvec3(0, 0.3, 0), 2.1 * i,
          glm::dvec3(i % 3 ? size : -size, size, size));
  }
}

}  // namespace

void add_furniture(Scene& s, const Palette& palette) {
  add_banners(s, palette);
  add_fences(s, palette);
  add_glowing(s, palette);
  add_growths(s, palette);
  add_plants(s, palette);
  set_motion(s, "banner", {.reach = {0, 0, 0.1}, .turn_rad = 0.15, .period_s = 2.3});
  set_motion(s, "growth", {.reach = {0.1, 0, 0.05}, .turn_rad = 0.4, .period_s = 3});
  set_motion(s, "bush", {.turn_rad = 0.08, .period_s = 2.5});
}

}  // namespace assay::scene::builtin
