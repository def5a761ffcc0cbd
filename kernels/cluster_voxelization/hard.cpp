// Named hard cases.
#include <fmt/format.h>

#include <cmath>

#include "kernels/cluster_voxelization/inputs.h"

namespace assay::cluster_voxelization {

using glm::dmat3;
using glm::dvec3;

namespace {

Case of_lights(std::vector<ClusterItem> lights, Scene s = {}) {
  s.lights = std::move(lights);
  return s.to_case();
}

// 45° about z, then x.
dmat3 turned() {
  const double h = std::sqrt(0.5);
  return dmat3(dvec3(h, h * h, h * h), dvec3(-h, h * h, h * h), dvec3(0, -h, h));
}

ClusterItem moved(ClusterItem item, float x, int ulps) {
  for (; ulps > 0; --ulps) x = std::nextafter(x, INFINITY);
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -INFINITY);
  item.origin.x = x;
  return item;
}

std::vector<HardCase> eye() {
  return {
      {"apex_at_the_eye", "every side runs through the eye, as the cells' do",
       [] {
         return of_lights({pyramid(dvec3(0), {0, 0, 20}, 0.5), pyramid(dvec3(0), {3, -2, 20}, 0.1)});
       }},
      {"apex_behind_the_eye", "corners on both sides of the eye: projections change sign",
       [] {
         return of_lights({pyramid({0.3, 0.1, -2}, {0, 0, 30}, 1.2), pyramid({0, 0, -1}, {0, 0, -5}, 1)});
       }},
      {"camera_inside", "a box round the eye reaches every column of the near slices",
       [] {
         return of_lights({box(dvec3(0.1, 0.2, 0.1), turned() * 3.0), box(dvec3(0), dmat3(50))});
       }},
      {"beside_the_eye", "half of it lies behind; a column of the middle is right of none of it",
       [] {
         return of_lights({box({3, 0, 0}, dmat3(2)), box({0, -4, 0.5}, turned() * 2.0)});
       }},
      {"behind_the_eye", "none of it is in view",
       [] {
         return of_lights({box({0, 0, -9}, dmat3(2))});
       }},
  };
}

std::vector<HardCase> touching() {
  std::vector<HardCase> cases = {
      {"on_a_slice", "a box from one boundary of slices to the next, exactly",
       [] {
         const auto e = Scene{}.edges();
         const double from = e[16 + 8 + 2 + 10], to = e[16 + 8 + 2 + 12];
         return of_lights({box({0, 0, (from + to) / 2}, dmat3(0.1, 0, 0, 0, 0.1, 0, 0, 0, (to - from) / 2))});
       }},
      {"through_corners", "faces through the corners of cells, square to no axis",
       [] {
         const Scene s;
         const auto e = s.edges();
         std::vector<ClusterItem> items;
         for (uint i = 1; i < 16; ++i) {
           const double z = e[26 + i];
           items.push_back(pyramid({e[i] * z, e[17 + i % 9] * z, z}, {0.3, 0.2, 1}, 0.4));
         }
         return of_lights(items);
       }},
  };
  for (const int ulps : {-1, 0, 1})
    cases.push_back({"beside_a_column_" + std::to_string(ulps + 1),
                     "a face in the plane of a column's edge, or an ulp beside it", [ulps] {
                       return of_lights({moved(box({0, 0, 10}, dmat3(1)), 1.0f, ulps),
                                         moved(box({0, 0, 10}, dmat3(0.5)), -0.5f, ulps)});
                     }});
  return cases;
}

std::vector<HardCase> shapes() {
  return {
      {"spot_of_a_tenth_degree", "four long edges that are nearly one",
       [] {
         return of_lights({pyramid({-5, 1, 3}, {9, 1, 40}, 0.001745), pyramid({4, 0, 9}, {-8, 0.1, 0}, 0.001745)});
       }},
      {"spot_of_89_degrees", "nearly flat, and a hundred times as wide as deep",
       [] {
         return of_lights({pyramid({0, 0, 30}, {0.1, 0.05, -0.2}, 57.29)});
       }},
      {"thin_at_45_degrees", "1000 : 1, between the axes: bounds say little, faces and edges all",
       [] {
         const dmat3 t = turned();
         return of_lights({box({0, 0, 25}, dmat3(t[0] * 20.0, t[1] * 0.02, t[2] * 0.02)),
                           box({2, 1, 8}, dmat3(t[0] * 0.005, t[1] * 5.0, t[2] * 0.005))});
       }},
      {"long_between_cells", "an edge passes an edge: neither one's faces keep them apart",
       [] {
         std::vector<ClusterItem> items(64);
         Pcg32 rng(7);
         for (ClusterItem& item : items) item = random_spot(rng, {}, 4, 10);
         return of_lights(items);
       }},
      {"empty_shapes", "a point, a line and a plane have faces without a direction",
       [] {
         return of_lights({box({0.1, 0.1, 5}, dmat3(0.0)), box({1, 0, 9}, dmat3(dvec3(1, 1, 1), dvec3(0), dvec3(0))),
                           box({-1, 0, 9}, dmat3(dvec3(1, 0, 0), dvec3(0, 1, 1), dvec3(0))),
                           pyramid({0, 1, 9}, {0, 0, 2}, 0)});
       }},
      {"far_away", "10^4 m away, one cell in reach",
       [] {
         return of_lights({pyramid({3000, 1000, 10000}, {-50, 0, 900}, 0.01)});
       }},
      {"small_items", "smaller than a cell: only the bounds keep them to it",
       [] {
         std::vector<ClusterItem> items(96);
         Pcg32 rng(8);
         for (ClusterItem& item : items) item = random_box(rng, {}, 0.05, 2);
         return of_lights(items);
       }},
      {"not_numbers", "NaN, infinite, beyond 2^38: counted, in no cell",
       [] {
         std::vector<ClusterItem> items(5, box({0, 0, 10}, dmat3(1)));
         items[0].origin.x = NAN, items[1].a.z = INFINITY, items[2].c.y = -0x1p38f, items[3].b.x = 0x1p37f;
         return of_lights(items);
       }},
      {"other_shapes", "a shape that there is not is a box",
       [] {
         ClusterItem item = pyramid({0, 0, 5}, {0, 0, 4}, 0.5);
         item.shape = 7;
         return of_lights({item});
       }},
  };
}

std::vector<HardCase> grids() {
  const auto kinds = [](uint lights, uint decals, uint probes, Scene s) {
    Pcg32 rng(lights + decals + probes);
    for (uint i = 0; i < lights; ++i) s.lights.push_back(random_spot(rng, s, 5, 40));
    for (uint i = 0; i < decals; ++i) s.decals.push_back(random_box(rng, s, 3, 4));
    for (uint i = 0; i < probes; ++i) s.probes.push_back(random_box(rng, s, 9, 2));
    return s.to_case();
  };
  const auto grid = [](uint columns, uint rows, uint slices) {
    Scene s;
    s.columns = columns, s.rows = rows, s.slices = slices;
    return s;
  };
  std::vector<HardCase> cases = {
      {"nothing", "no item at all", [=] { return kinds(0, 0, 0, grid(16, 8, 24)); }},
      {"no_cells", "a grid without slices", [=] { return kinds(3, 3, 3, grid(16, 8, 0)); }},
      {"one_cell", "all items in one cell: every bit of every word",
       [=] {
         Scene s = grid(1, 1, 1);
         s.lights.assign(70, box({0, 0, 5}, dmat3(1)));
         s.probes = s.lights;
         return s.to_case();
       }},
      {"kinds_31_33_1", "words that end before a group's threads do",
       [=] { return kinds(31, 33, 1, grid(16, 8, 24)); }},
      {"kinds_32_1_64", "words that are full", [=] { return kinds(32, 1, 64, grid(5, 3, 7)); }},
      {"over_the_whole_grid", "one item in each of 120x68x24 cells: eight blocks of rows",
       [=] {
         Scene s = grid(120, 68, 24);
         s.lights = {box({0, 0, 0}, dmat3(9000)), box({3, 1, 12}, turned() * 2.0)};
         return s.to_case();
       }},
      {"far_over_near_10_7", "slices that are seven tenths of their depth",
       [=] {
         Scene s = grid(16, 8, 24);
         s.near = 0.001, s.far = 10000;
         return kinds(40, 0, 0, s);
       }},
      {"field_of_view_170", "slopes up to 11",
       [=] {
         Scene s = grid(16, 8, 24);
         s.slope_x = 11.43, s.slope_y = 6.43;
         return kinds(40, 20, 0, s);
       }},
      {"counts_out_of_range", "more columns, rows and slices than there may be",
       [=] {
         Scene s = grid(kMaxClusterColumns, kMaxClusterRows, kMaxClusterSlices);
         s.lights = {pyramid({1, 1, 3}, {0, 0, 9}, 0.5)};
         Case c = s.to_case();
         ClusterParams p = c.params<ClusterParams>();
         p.columns = 121, p.rows = 0xffffffffu, p.slices = 33;
         c.set_params(p);
         return c;
       }},
  };
  // How time grows with items: as many lights as decals, a sixteenth as many probes.
  for (uint n = kMaxClusterLights; n >= 256; n /= 2)
    for (const bool fine : {false, true})
      cases.push_back(
          {fmt::format("{}_{}", fine ? "fine" : "coarse", n),
           fmt::format("{0} lights, {0} decals, {1} probes in {2}x24 cells", n, n / 16, fine ? "120x68" : "16x8"),
           [=] { return many(n, fine).to_case(); }, true});
  cases.push_back({"lights_1024", "1024 lights in 16x8x24 cells",
                   [] {
                     Scene s = many(1024, false);
                     s.decals.clear(), s.probes.clear();
                     return s.to_case();
                   },
                   true});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = eye();
  for (auto& more : {touching(), shapes(), grids(), raster_cases()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace assay::cluster_voxelization
