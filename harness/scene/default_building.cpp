// The hall of `default`: floors of two triangles, walls, a vault, and columns carved down to triangles of a pixel.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "harness/scene/default_scene.h"

namespace assay::scene::builtin {
namespace {

constexpr double kFront_m = 28, kColumnHeight_m = 6.5, kCarpet_m = 1, kVaultRise_m = 3;

// Lies on the ground around the origin, facing up.
uint32_t add_slab(Scene& s, const std::string& name, uint32_t material, double wide, double deep,
                  const glm::vec2& repeats) {
  return add_patch_mesh(s, name, material, 1, 1, repeats,
                        [=](double u, double v) { return glm::dvec3(wide * (u - 0.5), 0, deep * (0.5 - v)); });
}
// Stands on the ground above the origin, facing +z.
uint32_t add_wall(Scene& s, const std::string& name, uint32_t material, double wide, double tall,
                  const glm::vec2& repeats) {
  return add_patch_mesh(s, name, material, 1, 1, repeats,
                        [=](double u, double v) { return glm::dvec3(wide * (u - 0.5), tall * v, 0); });
}

void add_floors(Scene& s, const Palette& palette) {
  const double aisle = kHallWidth_m / 2 - kColumnX_m, nave = kColumnX_m - kCarpet_m;
  for (uint32_t b = 0; b < kBays; ++b) {
    const uint32_t runner = add_slab(s, "runner", palette(kShaderCloth, b), 2 * kCarpet_m, kBayLength_m, {2, 7});
    place(s, runner, {0, 0, middle(b)});
    for (uint32_t side = 0; side < 2; ++side) {
      const double sign = side ? 1 : -1;
      const uint32_t outer =
          add_slab(s, "aisle floor", palette(kShaderTwoLayer, 2 * b + side), aisle, kBayLength_m, {2, 2.5f});
      place(s, outer, {sign * (kColumnX_m + aisle / 2), 0, middle(b)});
      const uint32_t floor = b % 2 ? palette(kShaderTwoLayer, b + side) : palette(kShaderWet, b / 2 + 2 * side);
      const uint32_t inner = add_slab(s, "nave floor", floor, nave, kBayLength_m, {1.5f, 3});
      place(s, inner, {sign * (kCarpet_m + nave / 2), 0, middle(b)});
    }
  }
}

void add_walls(Scene& s, const Palette& palette) {
  const double base = 2.6;
  for (uint32_t b = 0; b < kBays; ++b)
    for (uint32_t side = 0; side < 2; ++side) {
      const uint32_t upper =
          add_wall(s, "wall", palette(kShaderOpaque, 2 + 3 * b + side), kBayLength_m, kWallHeight_m - base, {3, 3});
      const uint32_t lower =
          add_wall(s, "wall base", palette(kShaderTwoLayer, 2 * b + 3 + side), kBayLength_m, base, {3.5f, 1.3f});
      const double x = kHallWidth_m / 2, turn = side ? -kTau / 4 : kTau / 4;
      place(s, upper, {side ? x : -x, base, middle(b)}, turn);
      place(s, lower, {side ? x - 0.1 : 0.1 - x, 0, middle(b)}, turn);
    }
  const uint32_t end =
      add_wall(s, "end wall", palette(kShaderOpaque, 5), kHallWidth_m, kWallHeight_m + kVaultRise_m, {6, 4});
  place(s, end, {0, 0, -kFront_m});
  place(s, end, {0, 0, kFront_m}, kTau / 2);
  for (uint32_t b = 0; b < kBays; ++b) {
    const uint32_t vault =
        add_patch_mesh(s, "vault", palette(kShaderOpaque, 8 + b % 3), 48, 2, {8, 2}, [](double u, double v) {
          const double x = 2 * u - 1;
          return glm::dvec3(x * kHallWidth_m / 2, kWallHeight_m + kVaultRise_m * std::sqrt(1.01 - x * x) - 0.3,
                            (v - 0.5) * kBayLength_m);
        });
    place(s, vault, {0, 0, middle(b)});
  }
}

// Radii of a column at a turn u and a height v of each of its parts.
double foot(double u, double v) {
  const double corner = std::pow(std::fabs(std::cos(u * kTau * 2)), 6);  // nearly square below, round above
  return 0.72 - 0.16 * v + 0.1 * corner * (1 - v) + 0.05 * std::sin(v * kTau * 1.5) * v;
}
double twisted_shaft(double u, double v) {
  const double flute = std::fabs(std::sin((8 * u + 1.5 * v) * kTau));
  const double scales = std::sin(u * kTau * 32) * std::sin(v * kTau * 24);
  return 0.52 - 0.07 * v + 0.04 * flute + 0.008 * scales;
}
double chequered_shaft(double u, double v) {
  const double studs = std::pow(std::fabs(std::cos(u * kTau * 12) * std::cos(v * kTau * 20)), 4);
  const double bands = std::exp(-std::pow((v - 0.5) * 14, 2)) * 0.06;
  return 0.5 - 0.06 * v + 0.03 * studs + bands;
}
double capital(double u, double v) {
  const double petals = std::fabs(std::cos(u * kTau * 4)) * std::sin(v * glm::pi<double>() * 2);
  return 0.5 + 0.25 * v * v + 0.07 * petals;
}

void append_turned(Mesh& mesh, uint32_t columns, uint32_t rows, const glm::vec2& repeats, double low, double high,
                   double (*radius)(double, double)) {
  append_patch(mesh, columns, rows, repeats, [=](double u, double v) {
    const double r = radius(u, v);
    return glm::dvec3(r * std::sin(u * kTau), low + (high - low) * v, r * std::cos(u * kTau));
  });
}

uint32_t add_column(Scene& s, double (*shaft)(double, double), uint32_t below, uint32_t between, uint32_t above) {
  Mesh mesh;
  mesh.name = "column";
  append_turned(mesh, 64, 20, {4, 1}, 0, 0.9, foot);
  end_part(mesh, below);
  append_turned(mesh, 160, 96, {4, 6}, 0.9, 5.6, shaft);
  end_part(mesh, between);
  append_turned(mesh, 80, 24, {4, 1}, 5.6, kColumnHeight_m, capital);
  return add_mesh(s, std::move(mesh), above);
}

void add_columns(Scene& s, const Palette& palette) {
  const auto stone = [&](uint32_t i) { return palette(kShaderOpaque, i); };
  const uint32_t kinds[] = {add_column(s, twisted_shaft, stone(1), stone(5), stone(7)),
                            add_column(s, chequered_shaft, stone(4), stone(6), stone(14)),
                            add_column(s, twisted_shaft, stone(0), stone(7), stone(13))};
  for (uint32_t b = 0; b < kBays; ++b)
    for (uint32_t side = 0; side < 2; ++side) {
      const double z = middle(b) - kBayLength_m / 2 + 0.7;
      place(s, kinds[b % 3], {side ? kColumnX_m : -kColumnX_m, 0, z}, 0.4 * b, {side ? 1.0 : -1.0, 1, 1});
    }
  // Ribs over each pair of columns, from wall to wall under the vault.
  const uint32_t rib = add_patch_mesh(s, "rib", stone(11), 12, 96, {1, 12}, [](double u, double v) {
    const double turn = (v - 0.5) * 2.9, along = std::sin(turn), up = std::cos(turn);
    const double radius = 0.22 + 0.03 * std::cos(v * kTau * 24), out = radius * std::cos(u * kTau);
    return glm::dvec3(along * (9.7 + out), 7.3 + up * (3.6 + out), radius * std::sin(u * kTau));
  });
  for (uint32_t b = 0; b < kBays; ++b) place(s, rib, {0, 0, middle(b) - kBayLength_m / 2 + 0.7});
}

}  // namespace

void add_building(Scene& s, const Palette& palette) {
  add_floors(s, palette);
  add_walls(s, palette);
  add_columns(s, palette);
}

}  // namespace assay::scene::builtin
