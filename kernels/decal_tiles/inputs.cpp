#include "kernels/decal_tiles/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/clusters.h"
#include "harness/crop.h"
#include "harness/vrcs_screens.h"
#include "kernels/decal_tiles/oracle.h"

namespace assay::decal_tiles {

namespace {

constexpr uint32_t kFirstRange = 5;  // what lies before is no number

// As the depth pyramid has them: what is no positive number is the background, 0; infinity is nearest.
std::vector<vec2> ranges_of(Extent e, const std::vector<float>& depth) {
  const uint32_t across = tiles_of(e, kDecalTileSide).width;
  std::vector<vec2> ranges(tile_count(e, kDecalTileSide), vec2(INFINITY, 0));
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      const float read = depth[size_t{y} * e.width + x], d = read > 0 ? read : 0.0f;
      vec2& range = ranges[size_t{y / kDecalTileSide} * across + x / kDecalTileSide];
      range = {std::min(range.x, d), std::max(range.y, d)};
    }
  return ranges;
}

void set_ranges(Case& c, std::span<const vec2> ranges) {
  std::vector<vec2> all(kFirstRange, vec2(NAN));
  all.insert(all.end(), ranges.begin(), ranges.end());
  c.set_input("ranges", all);
}

}  // namespace

View::View(Extent e, Extent cell, uint32_t slices)
    : extent(e),
      grid(grid_over(e, cell, slices)),
      edges(reversed_slice_edges(slice_edges(kNear, kFar, slices), kNear)),
      depth(pixel_count(e)),
      cells(size_t{grid.columns} * grid.rows * slices) {}

float View::in_slice(uint32_t slice) const { return std::sqrt(edges[slice] * edges[slice + 1]); }

void View::list(uint32_t column, uint32_t row, uint32_t slice, uint32_t decals) {
  cells[(size_t{slice} * grid.rows + row) * grid.columns + column] = {7, counts(0, decals, 0)};
}
void View::list_at(uint32_t x, uint32_t y, float d) {
  uint32_t slice = 0;
  while (slice + 1 < grid.slices && d <= edges[slice + 1]) ++slice;
  list(x / grid.cell_width, y / grid.cell_height, slice);
}
void View::list_everywhere() { std::ranges::fill(cells, uvec2(0, counts(0, 1, 0))); }

Case View::to_case() const {
  Case c{.extent = extent};
  c.set_params(DecalTileParams{extent.width, extent.height, kFirstRange, grid});
  c.set_input("depth", depth);
  c.set_input("slice_edges", edges);
  c.set_input("cells", cells);
  set_ranges(c, ranges.empty() ? ranges_of(extent, depth) : ranges);
  return c;
}

Case typical(Extent e) {
  Pcg32 rng(0xdeca1);
  View v(e, coarse_cell(e), 24);
  v.depth = vrcs::typical_screen(e).depth;
  for (uint32_t i = 0; i < 300; ++i) {
    const uint32_t x = rng.below(e.width), y = rng.below(e.height);
    if (const float d = v.depth[size_t{y} * e.width + x]; d > 0) v.list_at(x, y, d);
  }
  return v.to_case();
}

Case in_frame(const FrameInputs& f) {
  constexpr uint32_t kLevel = 4;  // of 16 pixels
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(DecalTileParams{f.extent.width, f.extent.height, first_of_level(f.extent, kLevel), f.grid});
  return c;
}

namespace {

Extent random_cell(Random& r, Extent e) {
  switch (
      r.branch({{"cells_coarse", 0.2}, {"cells_of_32_pixels", 0.2}, {"cells_of_any_size", 0.5}, {"one_cell", 0.1}})) {
    case 0:
      return coarse_cell(e);
    case 1:
      return fine_cell(e);
    case 2:
      return {ceil_div(e.width, 1 + r.rng.below(kMaxClusterColumns)),
              ceil_div(e.height, 1 + r.rng.below(kMaxClusterRows))};
    default:
      return e;
  }
}

void fill_cells(Random& r, View& v) {
  constexpr uint32_t kOneIn[] = {0, 100, 3, 1};
  const uint32_t one_in =
      kOneIn[r.branch({{"decals_nowhere", 0.1}, {"decals_rare", 0.5}, {"decals_often", 0.3}, {"decals_all", 0.1}})];
  for (uvec2& cell : v.cells) {
    const bool has = one_in != 0 && r.rng.below(one_in) == 0;
    cell = {r.rng.next(), counts(r.rng.below(300), has ? 1 + r.rng.below(kClusterItemMask) : 0, r.rng.below(9))};
  }
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, 2 * kDecalTileSide);
  View v(e, random_cell(r, e), 1 + r.rng.below(kMaxClusterSlices));
  v.depth = vrcs::random_screen(r, e).depth;
  fill_cells(r, v);
  constexpr float kOdd[] = {NAN, -NAN, INFINITY, -INFINITY, -0.5f, 1e-40f, 1e-18f, 9e-19f, 1, 3e38f};
  if (r.branch({{"depths_drawn", 0.7}, {"depths_odd", 0.3}}) == 1)
    for (float& d : v.depth)
      if (r.rng.below(50) == 0) d = kOdd[r.rng.below(10)];
  if (r.branch({{"ranges_of_depths", 0.9}, {"ranges_odd", 0.1}}) == 1)
    for (uint64_t t = 0; t < tile_count(e, kDecalTileSide); ++t)
      v.ranges.emplace_back(kOdd[r.rng.below(10)], kOdd[r.rng.below(10)]);
  return v.to_case();
}

// Pixels at the right and below are taken off: cells stay where they are.
std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) {
    if (crop.at.width != 0 || crop.at.height != 0) continue;
    Case smaller = c;
    smaller.extent = crop.size;
    auto p = c.params<DecalTileParams>();
    p.width = crop.size.width, p.height = crop.size.height;
    smaller.set_params(p);
    smaller.set_input("depth", cropped(c.input<float>("depth"), c.extent, crop));
    set_ranges(smaller, cropped(c.input<vec2>("ranges").subspan(kFirstRange), tiles_of(c.extent, kDecalTileSide),
                                {{0, 0}, tiles_of(crop.size, kDecalTileSide)}));
    cases.push_back(std::move(smaller));
  }
  return cases;
}

// Of tiles, what is listed, and what of it no pixel's cell asks for.
std::vector<Figure> figures(const Variant&, const Case& c, const std::map<std::string, Bytes>& written) {
  uint count;
  std::memcpy(&count, written.at("count").data(), sizeof(count));
  const auto by_pixel = tiles_by_pixel(c);
  const auto needed = static_cast<double>(std::ranges::count(by_pixel, true));
  const auto all = static_cast<double>(by_pixel.size());
  return {{"tiles listed, %", 100 * count / all}, {"of them for no pixel, %", 100 * (count - needed) / count}};
}

}  // namespace

ErrorTable figures_table() {
  ErrorTable t = {.classes = {}, .figures = figures};
  const auto add = [&](const std::string& name, const std::string& why, Extent cell, uint32_t decals) {
    t.classes.push_back({name, why, [=] {
                           constexpr Extent kView = {1280, 720};
                           View v(kView, cell, 24);
                           v.depth = vrcs::typical_screen(kView).depth;
                           Pcg32 rng(decals);
                           for (uint32_t i = 0; i < decals; ++i) {
                             const uint32_t x = rng.below(kView.width), y = rng.below(kView.height);
                             v.list_at(x, y, v.depth[size_t{y} * kView.width + x]);
                           }
                           Case c = v.to_case();
                           c.name = name;
                           return c;
                         }});
  };
  add("10 cells of 80x90 pixels", "few decals, coarse cells", {80, 90}, 10);
  add("10 cells of 32x32 pixels", "few decals, fine cells", {32, 32}, 10);
  add("300 cells of 80x90 pixels", "many decals, coarse cells", {80, 90}, 300);
  add("300 cells of 32x32 pixels", "many decals, fine cells", {32, 32}, 300);
  return t;
}

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  branches.insert(branches.end(), vrcs::kScreenBranches.begin(), vrcs::kScreenBranches.end());
  for (const char* b :
       {"cells_coarse", "cells_of_32_pixels", "cells_of_any_size", "one_cell", "decals_nowhere", "decals_rare",
        "decals_often", "decals_all", "depths_drawn", "depths_odd", "ranges_of_depths", "ranges_odd"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::decal_tiles
