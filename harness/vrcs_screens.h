// Screens for the kernels of variable-rate compute shading: what covers each pixel, and the rates. Host only.
#pragma once
#include <algorithm>

#include "harness/oracle.h"
#include "harness/vrcs_oracle.h"

namespace assay::vrcs {

struct Pictured {  // owns what a View looks at; pixels and cells in rows
  Extent extent = {};
  std::vector<uvec2> visibility = {};   // nothing at first
  std::vector<float> depth = {};        // reversed
  std::vector<uint> face_normals = {};  // octahedral, two snorm16, x in the low half
  std::vector<uint8_t> rates = {};      // 1x1 at first

  size_t place(uint x, uint y) const { return size_t{y} * extent.width + x; }
  void cover(uint x, uint y, uvec2 seen, float at = 0.01f) {
    visibility[place(x, y)] = seen;
    depth[place(x, y)] = at;
  }
  View view(uint frame) const { return {extent, visibility, rates, depth, frame}; }
};
Pictured empty_screen(Extent);
// One rate; seen(x, y): a pixel's visibility, or kVisibilityNone.
template <class F>
Pictured drawn(Extent e, uint8_t rate, F seen) {
  Pictured s = empty_screen(e);
  std::ranges::fill(s.rates, rate);
  for (uint y = 0; y < e.height; ++y)
    for (uint x = 0; x < e.width; ++x)
      if (const uvec2 v = seen(x, y); v != uvec2(kVisibilityNone)) s.cover(x, y, v);
  return s;
}
// A triangle over all of it.
inline Pictured of_one(Extent e, uint8_t rate) {
  return drawn(e, rate, [](uint, uint) { return uvec2(7, 3); });
}
// Tiles of 64 cells at 2x2 with three primaries each, but for so many of them with four.
Pictured of_primaries(Extent, uint more_than_192);
uint focal_of(Extent);  // pixels, of 90 degrees across

// Rates of cells, by blocks of `side` cells, two in five of them 2x2.
std::vector<uint8_t> rates_in_blocks(Extent, Pcg32&, uint side);
// By blocks, cells, all of one, or of any value. Branches: kRateBranches.
std::vector<uint8_t> random_rates(Random&, Extent);
extern const std::vector<std::string> kRateBranches;

// A floor, walls and hills of triangles of 4 to 40 pixels under a third of sky; rates by block of 8x8, two in five of
// them 2x2.
Pictured typical_screen(Extent);
// One uneven surface everywhere, of triangles of side^2 / 2 pixels, at a rate of 2x2.
Pictured uneven_screen(Extent, uint side);
// Branches: kScreenBranches, with those of the rates.
Pictured random_screen(Random&, Extent);
extern const std::vector<std::string> kScreenBranches;

}  // namespace assay::vrcs
