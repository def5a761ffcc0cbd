// What an item looks like from the eye: planes through the eye and its edges, and its faces as polygons of their own.
// In double; shares nothing with the shaders.
#pragma once
#include "kernels/cluster_voxelization/solid.h"

namespace assay::cluster_voxelization {

// A half-space through the eye and one of the item's edges, the item on its inner side. A device that finds the item on
// one side keeps it; where rounding may tell another story it is not certain.
struct Side {
  Axis axis;
  bool certain = true;
};
std::vector<Side> outline_of(const ClusterItem&, const Item&);

// May and must: whether a device takes the face for one that is seen, and for one that is not; it may be both.
struct Facing {
  bool may = true, must = true;
};
struct Face {
  Item hull;                 // its corners, the item's reach
  std::vector<Axis> planes;  // its own, and those through the eye and its edges; either side
  Facing front, back;
};
std::vector<Face> faces_of(const ClusterItem&, const Item&);

// Whether all of the item's faces have the eye on their inner side.
Facing eye_inside(const Item&);

}  // namespace assay::cluster_voxelization
