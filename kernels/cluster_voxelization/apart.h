// Whether an item and a cell are apart, three-valued: what a device may say and what it must. In double, of corners.
#pragma once
#include <cmath>
#include <span>

#include "harness/oracle.h"
#include "kernels/cluster_voxelization/oracle.h"
#include "kernels/cluster_voxelization/solid.h"

namespace assay::cluster_voxelization {

using glm::dvec2;

inline constexpr double kRounding = 8 * kUnitRoundoff * (1 + 0x1p-18), kTiny = 0x1p-79;  // README, Error

// What a device may say of two things that are `gap` apart along an axis (below 0: they overlap).
struct Said {
  bool may_keep = true, must_keep = true;
  Said operator&&(const Said& o) const { return {may_keep && o.may_keep, must_keep && o.must_keep}; }
};

dvec2 interval(const Item&, const dvec3& direction);
// Along an axis; `both`: whichever of the two lies before the other, else the cell beyond the item.
Said along(const Item&, const Cell&, const Axis&, bool both);
// All of the item on one side of a plane through the eye, whose slope is an edge of the grid, exactly: of those that
// lie at smaller slopes, or at larger.
Said beside(const Item&, const dvec3& direction, bool larger);

// The grid's planes. Indices as of cells; a cell's far side is that of the next.
struct Edges {
  Grid grid;
  std::span<const float> of;
  double column(uint i) const { return of[i]; }
  double row(uint i) const { return of[grid.columns + 1 + i]; }
  double slice(uint i) const { return of[grid.columns + grid.rows + 2 + i]; }
  Cell cell(uint x, uint y, const dvec2& depths) const {
    return cell_of({column(x), column(x + 1)}, {row(y), row(y + 1)}, depths);
  }
  Cell cell(uint x, uint y, uint z) const { return cell(x, y, dvec2(slice(z), slice(z + 1))); }
};

// First and last of what the item reaches: at most, and at least (first > last: perhaps nothing).
struct Reach {
  uint first = 1, last = 0, sure_first = 1, sure_last = 0;
  bool may(uint i) const { return i >= first && i <= last; }
  bool must(uint i) const { return i >= sure_first && i <= sure_last; }
};
struct Bounds {
  Reach columns, rows, slices;
};
Bounds bounds_of(const Item&, const Edges&);

Said by_faces(const Item&, const Cell&);
Said by_edges(const Item&, const Cell&);  // directions square to one edge of each
Said by_sides(const Item&, const Cell&);  // the cell's own

// Whether they touch: no direction separates them. The exact answer, but for double's rounding, which counts as apart.
// `x`, `y`: the cell's column and row.
bool touches(const Item&, const Cell&, const Edges&, uint x, uint y);

}  // namespace assay::cluster_voxelization
