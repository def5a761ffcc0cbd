#include "kernels/cluster_voxelization/inputs.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "harness/clusters.h"

namespace assay::cluster_voxelization {

using glm::dmat3;
using glm::dvec3;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr uint kFirstRange = 5;

}  // namespace

std::vector<float> Scene::edges() const {
  std::vector<float> all;
  for (uint i = 0; i <= columns; ++i) all.push_back(static_cast<float>(slope_x * (2.0 * i / columns - 1)));
  for (uint i = 0; i <= rows; ++i) all.push_back(static_cast<float>(slope_y * (2.0 * i / rows - 1)));
  const std::vector<float> depths = slice_edges(near, far, slices);
  all.insert(all.end(), depths.begin(), depths.end());
  if (extended) all[columns + rows + 2] = 0, all.back() = std::max(1e5f, all.back());
  return all;
}

Case Scene::to_case() const {
  Case c{.extent = {columns, rows}};
  c.set_params(ClusterParams{static_cast<uint>(lights.size()), static_cast<uint>(decals.size()),
                             static_cast<uint>(probes.size()), columns, rows, slices, static_cast<float>(near),
                             kFirstRange});
  std::vector<ClusterItem> items = lights;
  for (const auto* more : {&decals, &probes}) items.insert(items.end(), more->begin(), more->end());
  c.set_input("items", items);
  c.set_input("edges", edges());
  // Before them lies what says that there is nothing anywhere.
  std::vector<vec2> ranges(kFirstRange, vec2(0));
  if (depth_ranges.empty())
    ranges.resize(kFirstRange + size_t{columns} * rows, vec2(0, 1));
  else
    ranges.insert(ranges.end(), depth_ranges.begin(), depth_ranges.end());
  c.set_input("depth_ranges", ranges);
  return c;
}

ClusterItem box(const dvec3& at, const dmat3& axes) {
  return {vec3(at), kShapeBox, vec3(axes[0]), vec3(axes[1]), vec3(axes[2])};
}

ClusterItem pyramid(const dvec3& apex, const dvec3& axis, double across) {
  const dvec3 aside = std::fabs(axis.x) < std::fabs(axis.y) ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  const dvec3 u = normalize(cross(axis, aside)), v = normalize(cross(axis, u));
  const double half = across * length(axis);
  return {vec3(apex), kShapePyramid, vec3(u * half), vec3(v * half), vec3(axis)};
}

dmat3 rotation(Pcg32& rng) {  // Shoemake 1992
  const double a = rng.unit(), b = 2 * kPi * rng.unit(), c = 2 * kPi * rng.unit();
  return glm::mat3_cast(glm::dquat(std::sqrt(a) * std::cos(c), std::sqrt(1 - a) * std::sin(b),
                                   std::sqrt(1 - a) * std::cos(b), std::sqrt(a) * std::sin(c)));
}

namespace {

// Somewhere in the view, its depth even in the logarithm.
dvec3 in_view(Pcg32& rng, const Scene& s) {
  const double z = s.near * std::pow(s.far / s.near, rng.unit());
  return {z * s.slope_x * rng.range(-1, 1), z * s.slope_y * rng.range(-1, 1), z};
}

}  // namespace

ClusterItem random_box(Pcg32& rng, const Scene& s, double radius, double aspect) {
  dvec3 half;
  for (int i = 0; i < 3; ++i) half[i] = std::pow(aspect, -rng.unit());
  half *= radius / length(half);
  const dmat3 turn = rotation(rng);
  return box(in_view(rng, s), dmat3(turn[0] * half.x, turn[1] * half.y, turn[2] * half.z));
}

ClusterItem random_spot(Pcg32& rng, const Scene& s, double radius, double half_angle_deg) {
  return pyramid(in_view(rng, s), rotation(rng)[2] * radius, std::tan(half_angle_deg * kPi / 180));
}

Scene many(uint n, bool fine) {
  Scene s;
  if (fine) s.columns = 120, s.rows = 68;
  Pcg32 rng(0xc105);
  for (uint i = 0; i < n; ++i) {
    s.lights.push_back(i % 4 == 0 ? random_box(rng, s, rng.range(1, 4), 2)
                                  : random_spot(rng, s, rng.range(1, 8), rng.range(15, 55)));
    s.decals.push_back(random_box(rng, s, rng.range(0.1, 1), 6));
  }
  for (uint i = 0; i < n / 16; ++i) s.probes.push_back(random_box(rng, s, rng.range(2, 10), 3));
  return s;
}

Case typical(Extent e) {
  Case c = many(e.width >= 1920 ? 4096 : 256, e.width >= 3840).to_case();
  c.extent = e;
  return c;
}

namespace {

Scene random_grid(Random& r) {
  Scene s;
  switch (r.branch({{"grid_tiny", 0.15}, {"grid_usual", 0.42}, {"grid_fine", 0.3}, {"grid_any", 0.13}})) {
    case 0:
      s.columns = 1 + r.rng.below(3), s.rows = 1 + r.rng.below(3), s.slices = 1 + r.rng.below(3);
      break;
    case 1:
      break;
    case 2:
      s.columns = 60, s.rows = 34, s.slices = 4 + r.rng.below(21);
      break;
    default:
      s.columns = 1 + r.rng.below(kMaxClusterColumns), s.rows = 1 + r.rng.below(kMaxClusterRows);
      s.slices = 1 + r.rng.below(8);
  }
  if (r.branch({{"view_usual", 0.8}, {"view_odd", 0.2}}) == 1) {
    s.slope_x = std::tan(r.rng.range(5, 170) * kPi / 360), s.slope_y = s.slope_x * r.rng.range(0.3, 2);
    s.near = std::pow(10, r.rng.range(-2, 0)), s.far = s.near * std::pow(10, r.rng.range(0.5, 7));
  }
  s.extended = r.branch({{"slices_extended", 0.7}, {"slices_as_they_are", 0.3}}) == 0;
  return s;
}

// On a cell's corner, its faces square to the view or through the eye.
ClusterItem aligned(Pcg32& rng, const Scene& s) {
  const auto e = s.edges();
  const double z = e[s.columns + s.rows + 2 + rng.below(s.slices)];
  const dvec3 at(e[rng.below(s.columns + 1)] * z, e[s.columns + 1 + rng.below(s.rows + 1)] * z, z);
  const double half = std::ldexp(1.0, static_cast<int>(rng.below(8)) - 4);
  return rng.below(2) ? box(at + dvec3(0, 0, half), dmat3(half))
                      : pyramid(at, dvec3(at.x, at.y, at.z + 1) * half, 0.25);
}

ClusterItem random_item(Random& r, const Scene& s) {
  const double size = std::pow(10, r.rng.range(-2, 2));
  switch (r.branch({{"box", 0.33},
                    {"box_long", 0.1},
                    {"spot", 0.3},
                    {"spot_thin", 0.05},
                    {"spot_wide", 0.03},
                    {"aligned", 0.04},
                    {"round_the_eye", 0.07},
                    {"flat", 0.05},
                    {"out_of_range", 0.03}})) {
    case 0:
      return random_box(r.rng, s, size, 2);
    case 1:
      return random_box(r.rng, s, size, 1000);
    case 2:
      return random_spot(r.rng, s, size, r.rng.range(5, 60));
    case 3:
      return random_spot(r.rng, s, size, 0.1);
    case 4:
      return random_spot(r.rng, s, size, 89);
    case 5:
      return aligned(r.rng, s);
    case 6: {
      const dmat3 turn = rotation(r.rng);
      const dvec3 near_eye = turn[0] * r.rng.range(0, 2 * size);
      return r.rng.below(2) ? box(near_eye, rotation(r.rng) * size) : pyramid(near_eye, turn[2] * size, 0.5);
    }
    case 7: {
      ClusterItem item = random_box(r.rng, s, size, 2);
      (r.rng.below(2) ? item.a : item.c) = vec3(0);
      if (r.rng.below(3) == 0) item.b = vec3(0);
      return item;
    }
    default: {
      ClusterItem item = random_box(r.rng, s, size, 2);
      constexpr float kOdd[] = {NAN, INFINITY, -INFINITY, 0x1p38f, -0x1p60f, 3e38f};
      item.b.y = kOdd[r.rng.below(6)];
      return item;
    }
  }
}

// A reversed depth that a device may meet, of a distance from the near plane on; some lie on slices.
float random_depth(Pcg32& rng, const Scene& s, const std::vector<float>& edges) {
  const double at = s.near * std::pow(s.far / s.near, rng.unit());
  const double z = rng.below(8) ? at : edges[s.columns + s.rows + 2 + rng.below(s.slices + 1)];
  return static_cast<float>(s.near / std::max(z, s.near));
}

void add_depths(Random& r, Scene& s) {
  const size_t kind = r.branch({{"depths_open", 0.4}, {"depths_of_surfaces", 0.5}, {"depths_odd", 0.1}});
  if (kind == 0) return;
  const auto edges = s.edges();
  constexpr float kOdd[] = {NAN, INFINITY, -INFINITY, -1, 0, 1e-40f, 1e-31f, 3e38f, 2};
  for (uint i = 0; i < s.columns * s.rows; ++i) {
    vec2 range(random_depth(r.rng, s, edges), random_depth(r.rng, s, edges));
    if (range.x > range.y) std::swap(range.x, range.y);
    if (r.rng.below(8) == 0) range.x = r.rng.below(2) ? 0.0f : range.y;  // background beside it; all at one depth
    if (r.rng.below(16) == 0) range = vec2(0);
    if (kind == 2 && r.rng.below(2)) range[static_cast<int>(r.rng.below(2))] = kOdd[r.rng.below(9)];
    s.depth_ranges.push_back(range);
  }
}

Case random_case(Random& r) {
  Scene s = random_grid(r);
  add_depths(r, s);
  const size_t how_many =
      r.branch({{"items_none", 0.03}, {"items_few", 0.35}, {"items_some", 0.5}, {"items_many", 0.12}});
  const uint most[] = {0, 5, 100, 700};
  const auto fill = [&](std::vector<ClusterItem>& items, uint n) {
    for (; n > 0; --n) items.push_back(random_item(r, s));
  };
  if (how_many > 0) {
    fill(s.lights, r.rng.below(most[how_many] + 1));
    fill(s.decals, r.rng.below(most[how_many] / 2 + 1));
    fill(s.probes, r.rng.below(std::min(most[how_many], 60u) + 1));
  }
  return s.to_case();
}

// Without half of the items of a kind, or one.
std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  const auto p = c.params<ClusterParams>();
  const uint n[] = {p.lights, p.decals, p.probes};
  const auto items = c.input<ClusterItem>("items");
  uint first = 0;
  for (int kind = 0; kind < 3; first += n[kind++])
    for (uint part = n[kind]; part > 0; part /= 2)
      for (uint at = 0; at < n[kind] && at < 4 * part; at += part) {
        const uint count = std::min(part, n[kind] - at);
        std::vector<ClusterItem> left(items.begin(), items.end());
        left.erase(left.begin() + first + at, left.begin() + first + at + count);
        ClusterParams q = p;
        (kind == 0 ? q.lights : kind == 1 ? q.decals : q.probes) -= count;
        cases.push_back(c);
        cases.back().set_params(q), cases.back().set_input("items", left);
      }
  return cases;
}

}  // namespace

Inputs inputs() {
  return {.random = random_case,
          .branches = {"grid_tiny",
                       "grid_usual",
                       "grid_fine",
                       "grid_any",
                       "view_usual",
                       "view_odd",
                       "slices_extended",
                       "slices_as_they_are",
                       "depths_open",
                       "depths_of_surfaces",
                       "depths_odd",
                       "items_none",
                       "items_few",
                       "items_some",
                       "items_many",
                       "box",
                       "box_long",
                       "spot",
                       "spot_thin",
                       "spot_wide",
                       "aligned",
                       "round_the_eye",
                       "flat",
                       "out_of_range"},
          .hard = hard_cases(),
          .smaller = smaller_cases};
}

}  // namespace assay::cluster_voxelization
