// An item or a cell as the hull of its corners, in double. Shares nothing with the shaders: intervals are of corners,
// not of centres and half axes.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "kernels/cluster_voxelization/layout.h"

namespace assay::cluster_voxelization {

using glm::dvec3;

// A direction, with what its components may be off where floats made it of the item's vectors.
struct Axis {
  dvec3 direction{0}, off{0};
};

struct Item {
  std::vector<dvec3> corners;
  std::vector<Axis> faces;  // outward; a box's in both directions
  std::vector<Axis> edges;  // directions
  dvec3 reach{0};           // |origin| + |a| + |b| + |c|: what rounding is of
};
bool is_usable(const ClusterItem&);  // finite and below 2^38
Item item_of(const ClusterItem&);

struct Cell {
  dvec3 corners[8];
  dvec3 reach[2];  // largest magnitudes, of the near four corners and the far
  dvec3 edges[6];  // x, y, and the four that run to the eye, as (x, y, 1)
};
Cell cell_of(const glm::dvec2& x, const glm::dvec2& y, const glm::dvec2& z);

}  // namespace assay::cluster_voxelization
