// Screens for the kernels of variable-rate compute shading: what covers each pixel, and the rates. Host only.
#pragma once
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
uint focal_of(Extent);  // pixels, of 90 degrees across

// A floor, walls and hills of triangles of 4 to 40 pixels under a third of sky; rates by block of 8x8, two in five of
// them 2x2.
Pictured typical_screen(Extent);
// One uneven surface everywhere, of triangles of side^2 / 2 pixels, at a rate of 2x2.
Pictured uneven_screen(Extent, uint side);
// Branches: kScreenBranches.
Pictured random_screen(Random&, Extent);
extern const std::vector<std::string> kScreenBranches;

}  // namespace assay::vrcs
