// An item against a column's slice, by its faces and its outline: what a variant that rasterises may keep, and must.
#pragma once
#include <algorithm>

#include "kernels/cluster_voxelization/outline.h"
#include "kernels/cluster_voxelization/raster.h"

namespace assay::cluster_voxelization {

inline dvec2 common(const dvec2& a, const dvec2& b) { return {std::max(a.x, b.x), std::min(a.y, b.y)}; }

// A cell as wide as a device may take it, and as narrow; either may be nothing.
struct Clipped {
  dvec2 wide, narrow;
  bool may() const { return wide.x <= wide.y; }
  bool sure() const { return narrow.x <= narrow.y; }
  // Surely; no plane through the eye keeps it away then.
  bool has_eye() const { return sure() && narrow.x <= 0; }
};

struct Column {  // of the screen: a column and a row
  const Edges& edges;
  uint x, y;
  Depths depths;

  // A slice, to the depths of the column and of a hull; a device may give the hull twice its room.
  // Slice -1: what lies before the first; one past the last: what lies beyond.
  Clipped slice(int z, const Item& hull) const;
};

struct Shape {
  Item item;
  std::vector<Side> outline;
  std::vector<Face> faces;
  Facing inside;
};

Shape shape_of(const ClusterItem&);

// Along an axis; `both`: whichever of the two lies before the other.
Said clipped_along(const Item& hull, const Column&, const Clipped&, const Axis&, bool both);
Said hexahedron(const Shape&, const Column&, uint z);

}  // namespace assay::cluster_voxelization
