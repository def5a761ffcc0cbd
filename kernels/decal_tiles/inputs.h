// Cases for the list of tiles that have decals.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/decal_tiles/layout.h"

namespace assay::decal_tiles {

Case typical(Extent);  // a floor and hills under a third of sky, decals at 300 pixels, cells of 16x8x24
Inputs inputs();
std::vector<Mutant> mutants();
Case in_frame(const FrameInputs&);
// How many tiles are listed, and how many of them for no pixel.
ErrorTable figures_table();

// ---- For hard.cpp

// Of a cell.
constexpr uint32_t counts(uint32_t lights, uint32_t decals, uint32_t probes) {
  return lights | decals << kClusterDecalShift | probes << kClusterProbeShift;
}

constexpr float kNear = 0.1f, kFar = 1000;  // of slices, metres

struct View {
  // Nothing to be seen, and cells that list nothing.
  View(Extent, Extent cell, uint32_t slices);
  Extent extent;
  ClusterGrid grid;
  std::vector<float> edges, depth;  // reversed
  std::vector<uvec2> cells;
  std::vector<vec2> ranges = {};  // of 16x16 pixels; empty: those of the depths

  float in_slice(uint32_t slice) const;  // a depth in the midst of it
  void list(uint32_t column, uint32_t row, uint32_t slice, uint32_t decals = 1);
  void list_at(uint32_t x, uint32_t y, float depth);  // in the pixel's cell
  void list_everywhere();
  Case to_case() const;
};
std::vector<HardCase> hard_cases();

}  // namespace assay::decal_tiles
