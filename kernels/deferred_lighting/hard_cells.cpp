// Hard cases of the lists of cells.
#include <cmath>
#include <numeric>

#include "harness/clusters.h"
#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/picture.h"

namespace assay::deferred_lighting {

namespace {

using Lights = std::vector<uint32_t>;

// A slanted wall under suns of different colours, so that any light but the listed ones shows.
Picture under_suns(Extent e, uint32_t suns) {
  Picture p = wall(e);
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) p.place(x, y, 2 + 0.1 * (x + y));
  Pcg32 rng(suns);
  for (uint32_t i = 0; i < suns; ++i)
    p.lights.push_back(directional({rng.range(-0.5, 0.5), rng.range(-0.5, 0.5), -1},
                                   vec3(std::exp2(i % 5), std::exp2(i % 7), std::exp2(i % 3))));
  return p;
}

std::function<Case()> of_cells(Extent picture, uint32_t suns, Extent cell, std::function<Lights(uint32_t)> lights_in) {
  return [=] {
    Picture p = under_suns(picture, suns);
    add_cells(p, cell, slice_edges(1, 20, 4), lights_in);
    return to_case("", p);
  };
}

Lights first_lights(uint32_t n) {
  Lights all(n);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// A slice each 0.5 m; depths at each boundary, one float nearer and one farther.
Case on_slices() {
  Picture p = under_suns({64, 24}, 24);
  std::vector<float> depths;
  for (int k = 0; k <= 24; ++k) depths.push_back(0.5f + 0.5f * static_cast<float>(k));
  add_cells(p, {64, 24}, depths, [](uint32_t slice) { return Lights{slice}; });
  for (uint32_t y = 0; y < 24; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      float d = p.slice_edges[y];
      for (uint32_t i = 0; i < x % 3; ++i) d = std::nextafter(d, 0.0f);
      for (uint32_t i = 0; i < x % 5; ++i) d = std::nextafter(d, 1.0f);
      p.depth[p.at(x, y)] = d;
    }
  return to_case("", p);
}

// Lists that begin or end past the last entry, name lights that there are not, the same one twice, and out of order.
Case hostile_lists() {
  Picture p = under_suns({40, 40}, 10);
  add_cells(p, {8, 8}, slice_edges(1, 20, 2), [](uint32_t cell) { return Lights{cell % 10, 9, 3, 3, 10, 4095, 0}; });
  const uint32_t all = static_cast<uint32_t>(p.entries.size());
  for (uint32_t i = 0; i < p.cells.size(); ++i) {
    const uvec2 odd[] = {p.cells[i], {all, 5}, {all - 2, 300}, {~0u, ~0u}, {0, 0xfffff000u}, {7, 4095}};
    p.cells[i] = odd[i % 6];
  }
  return to_case("", p);
}

Case no_cells() {
  Picture p = under_suns({33, 33}, 5);
  add_cells(p, {33, 33}, slice_edges(1, 20, 1), [](uint32_t) { return Lights{0}; });
  p.params.grid = {};
  p.cells = {}, p.entries = {}, p.slice_edges = {1};
  Case c = to_case("", p);
  return c;
}

// 640x360 pixels in cells of `cell` pixels, with 48 of 512 lights each; neighbours share half of them. For timing: a
// wave of 32 lanes is 8x4 pixels.
std::function<Case()> walked(Extent cell) {
  return [=] {
    Picture p = under_suns({640, 360}, 512);
    add_cells(p, cell, {0, 1e6f}, [](uint32_t i) {
      Lights some(48);
      std::iota(some.begin(), some.end(), i * 24 % 464);
      return some;
    });
    return to_case("", p);
  };
}

}  // namespace

std::vector<HardCase> cell_cases() {
  return {
      {"cells_of_one_light", "each cell has one light of its own, the last light too; cells wider than high",
       of_cells({70, 50}, 23, {20, 12}, [](uint32_t cell) { return Lights{cell % 23}; })},
      {"cells_within_a_wave", "a cell a pixel: lists of every length from 0 to 16 side by side, some lights in many",
       of_cells({48, 32}, 40, {1, 1},
                [](uint32_t cell) {
                  Lights some;
                  for (uint32_t i = cell % 5; i < 40 && some.size() < cell % 17; i += 1 + cell % 3) some.push_back(i);
                  return some;
                })},
      {"one_cell_for_all", "a grid of one column and row: every wave walks one list",
       of_cells({40, 40}, 30, {40, 40}, [](uint32_t) { return first_lights(30); })},
      {"full_lists", "256 lights in a cell, of 256",
       of_cells({20, 20}, 256, {16, 16}, [](uint32_t) { return first_lights(256); })},
      {"empty_lists", "lights, but none in any cell",
       of_cells({33, 33}, 9, {16, 16}, [](uint32_t) { return Lights(); })},
      {"depths_on_slices", "depths on each boundary of 24 slices, one float before and behind", on_slices},
      {"one_cell_a_wave", "48 lights a pixel, the waves within one cell: for timing", walked({32, 32}), true},
      {"four_cells_a_wave", "the same in cells of 4x2 pixels", walked({4, 2}), true},
      {"many_cells_a_wave", "the same in cells of a pixel: each lane has its own, up to 64 a wave", walked({1, 1}),
       true},
      {"hostile_lists", "lists past the last entry, lights past the last, twice, and out of order", hostile_lists},
      {"no_cells", "a grid without cells: nothing is listed", no_cells},
  };
}

}  // namespace assay::deferred_lighting
