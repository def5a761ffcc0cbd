// Which items touch which cells.
#pragma once
#include "harness/kernel.h"
#include "kernels/cluster_voxelization/layout.h"

namespace assay::cluster_voxelization {

struct Grid {
  uint columns, rows, slices;
  uint64_t cells() const { return uint64_t{columns} * rows * slices; }
};
Grid grid_of(const Case&);
struct ItemCounts {
  uint lights, decals, probes;
  uint all() const { return lights + decals + probes; }
};
ItemCounts item_counts(const Case&);
constexpr uint64_t words(uint count) { return (uint64_t{count} + 31) / 32; }

// The cells of each variant's test, three-valued. "two_way_lights" and so on: what touches must be marked, what the
// item's bounds or faces keep away by more than rounding must not. "exact_lights": likewise with every separating axis.
// raster.h has more.
Answer mark(const Case&);

// Pairs that touch: every separating axis overlaps by more than double's rounding.
uint64_t touching_pairs(const Case&);

}  // namespace assay::cluster_voxelization
