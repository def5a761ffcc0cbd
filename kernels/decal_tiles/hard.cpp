// Named hard cases, and the faults that they must find.
#include <cmath>

#include "harness/clusters.h"
#include "kernels/decal_tiles/inputs.h"

namespace assay::decal_tiles {

namespace {

constexpr Extent kExtent = {64, 48};  // 4 x 3 tiles
constexpr Extent kCell = {20, 12};

std::function<Case()> made(std::function<void(View&)> change, Extent e = kExtent, Extent cell = kCell,
                           uint32_t slices = 8) {
  return [=] {
    View v(e, cell, slices);
    change(v);
    return v.to_case();
  };
}
// Decals in all cells, and a surface of several depths over all of it.
std::function<Case()> full(Extent e) {
  return made(
      [](View& v) {
        for (size_t i = 0; i < v.depth.size(); ++i) v.depth[i] = v.in_slice(i % 8);
        v.list_everywhere();
      },
      e, {7, 5});
}
// Two depths in every tile, and decals in one slice.
std::function<Case()> slice_alone(uint32_t slice) {
  return made([=](View& v) {
    for (size_t i = 0; i < v.depth.size(); ++i) v.depth[i] = v.in_slice(i % 2 == 0 ? 2 : 5);
    for (uint32_t y = 0; y < v.grid.rows; ++y)
      for (uint32_t x = 0; x < v.grid.columns; ++x) v.list(x, y, slice);
  });
}

std::vector<HardCase> cell_cases() {
  return {
      {"no_decals", "nothing is listed, no group is asked for",
       made([](View& v) { v.depth.assign(v.depth.size(), 0.01f); })},
      {"lights_alone", "cells of lights and probes without a decal", made([](View& v) {
         v.depth.assign(v.depth.size(), 0.01f);
         v.cells.assign(v.cells.size(), uvec2(0xffffffffu, counts(0xfff, 0, 0xff)));
         v.list_at(40, 20, 0.01f);
       })},
      {"most_decals", "the count's highest bit alone", made([](View& v) {
         v.depth.assign(v.depth.size(), v.in_slice(3));
         v.list(1, 1, 3, 0x800);
       })},
      {"cell_begins_within", "the tile's last columns and rows are in another cell", made([](View& v) {
         v.depth.assign(v.depth.size(), v.in_slice(3));
         v.list(1, 1, 3);
       })},
      {"cells_wider_than_high", "columns and rows of different sizes", made([](View& v) {
         v.depth.assign(v.depth.size(), v.in_slice(3));
         v.list(2, 0, 3);
       })},
      {"beyond_the_grid", "pixels beyond the grid's last column and row are in those", made([](View& v) {
         v.depth.assign(v.depth.size(), v.in_slice(3));
         v.grid.columns = v.grid.rows = 2;
         v.cells.assign(size_t{2} * 2 * 8, uvec2(0));
         v.list(1, 1, 3);
       })},
      {"cell_a_pixel", "256 cells over a tile in 32 slices, and the last of all has the decal",
       made(
           [](View& v) {
             for (size_t i = 0; i < v.depth.size(); ++i) v.depth[i] = v.in_slice(i % 32);
             v.list(31, 31, 31);
           },
           {33, 35}, {1, 1}, 32)},
      {"one_cell", "over all of the view: every tile with a surface",
       made(
           [](View& v) {
             for (size_t i = 0; i < v.depth.size() / 2; ++i) v.depth[i] = 0.01f;
             v.list_everywhere();
           },
           kExtent, kExtent, 1)},
  };
}

std::vector<HardCase> depth_cases() {
  return {
      {"all_sky", "decals in all cells, and nothing that they lie on", made([](View& v) { v.list_everywhere(); })},
      {"nearest_slice", "decals in the slice of the nearest pixels alone", slice_alone(2)},
      {"farthest_slice", "in that of the farthest", slice_alone(5)},
      {"between", "in one between, where no pixel is: listed by the range alone", slice_alone(4)},
      {"before", "in front of all surfaces", slice_alone(1)},
      {"behind", "behind all surfaces", slice_alone(6)},
      {"one_pixel", "the last pixel of a tile, its last subgroup's", made([](View& v) {
         v.depth[size_t{31} * 64 + 47] = v.in_slice(3);
         v.list_everywhere();
       })},
      {"on_a_slice", "depths on the boundaries of slices, one float nearer and one farther",
       made(
           [](View& v) {
             for (uint32_t y = 0; y < v.extent.height; ++y)
               for (uint32_t x = 0; x < v.extent.width; ++x) {
                 const float edge = v.edges[1 + x / 16 % 22];
                 const float near_it[] = {edge, std::nextafter(edge, 0.0f), std::nextafter(edge, 1.0f)};
                 v.depth[size_t{y} * v.extent.width + x] = near_it[y / 16];
               }
             for (uint32_t slice = 0; slice < 24; slice += 2) v.list(0, 0, slice);
           },
           {352, 48}, {352, 48}, 24)},
      {"least_depth", "the least depth of a surface, and one float less", made([](View& v) {
         v.depth.assign(v.depth.size(), 0);
         for (size_t i = 0; i < v.depth.size(); i += 5)
           v.depth[i] = i % 64 < 32 ? kLeastDecalDepth : std::nextafter(kLeastDecalDepth, 0.0f);
         v.list_everywhere();
       })},
      {"no_surface", "NaN, negative, infinite and denormal depths: no pixel's, of infinite ones a range's",
       made([](View& v) {
         constexpr float kOdd[] = {NAN, -NAN, -1, INFINITY, -INFINITY, 1e-40f, -0.0f, 1e-30f};
         for (uint32_t y = 0; y < 48; ++y)
           for (uint32_t x = 0; x < 64; ++x) v.depth[size_t{y} * 64 + x] = kOdd[(y / 16 * 4 + x / 16) % 8];
         v.list_everywhere();
       })},
      {"odd_ranges", "no numbers, and the nearest farther than the farthest", made([](View& v) {
         v.depth.assign(v.depth.size(), 0.01f);
         v.ranges = {{NAN, NAN}, {0.01f, NAN},     {NAN, 0.01f},     {INFINITY, INFINITY},  {0.5f, 0.001f},  {-1, -1},
                     {-1, 0.5f}, {1e-40f, 1e-40f}, {1e-18f, 1e-18f}, {-INFINITY, INFINITY}, {NAN, INFINITY}, {0, 0}};
         v.list_everywhere();
       })},
  };
}

std::vector<HardCase> size_cases() {
  std::vector<HardCase> all = {
      {"groups_and_one", "more tiles than a group of threads takes", full({16 * 13, 16 * 10 + 1})},
      {"row_of_tiles", "as wide as can be", full({16384, 3})},
      {"column_of_tiles", "as high as can be", full({3, 16384})},
      {"size_3840x2160", "the frame's largest view",
       [] {
         return typical({3840, 2160});
       },
       true},
      {"rows_of_groups", "a list of more groups than a dimension of a dispatch holds", full({16384, 1025}), true},
  };
  for (const Extent e : {Extent{1, 1}, {8, 8}, {15, 17}, {16, 16}, {17, 15}, {1921, 1081}})
    all.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height), "a size at or beside a boundary",
                   full(e)});
  return all;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = cell_cases();
  for (auto& more : {depth_cases(), size_cases()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "cells of lights alone count", "lights_alone"},
      {"hi_z.comp", 2, "tiles without a surface are listed", "all_sky"},
      {"hi_z.comp", 3, "a tile lies in one cell", "cell_begins_within"},
      {"hi_z.comp", 4, "the nearest slice is left out", "nearest_slice"},
      {"hi_z.comp", 5, "the farthest slice is left out", "farthest_slice"},
      {"hi_z.comp", 6, "each group lists from the start on", "groups_and_one"},
      {"per_pixel.comp", 7, "the background takes decals", "all_sky"},
      {"per_pixel.comp", 8, "the barrier dropped", "one_pixel"},
      {"per_pixel.comp", 9, "one pixel is none", "one_pixel"},
      {"args.comp", 10, "the last tile has no group", "lights_alone"},
      {"harness/glsl/clusters.glsl", 9401, "a depth on a boundary is in the slice before", "on_a_slice"},
      {"harness/glsl/clusters.glsl", 9402, "columns as wide as rows are high", "cells_wider_than_high"},
  };
}

}  // namespace assay::decal_tiles
