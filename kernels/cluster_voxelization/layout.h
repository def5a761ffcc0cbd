// Parameters of the cluster voxelization.
#ifndef CLUSTER_VOXELIZATION_LAYOUT_H
#define CLUSTER_VOXELIZATION_LAYOUT_H
#include "harness/formats/clusters.h"
#include "harness/shared.h"
SHARED_BEGIN(cluster_voxelization)

SHARED_CONST uint kMaxPlanes = 6u;    // of an item
SHARED_CONST uint kMaxOutline = 24u;  // planes through the eye and an item's edges, both sides of twelve
SHARED_CONST uint kBinSide = 8u;      // columns and rows: 256 pixels where a column has 32

// How far an item is, no farther and no nearer whatever rounding did, in metres, and how many planes its outline has.
struct Outline {
  float nearest;
  float farthest;
  uint planes;  // up to kMaxOutline
};

// Counts beyond those of formats/clusters.h count as these.
struct ClusterParams {
  uint lights;  // items 0 .. lights - 1; decals and probes follow
  uint decals;
  uint probes;
  uint columns;
  uint rows;
  uint slices;
  float near_plane;  // metres; the depth of reversed depth 1. Unless in [2^-38, 2^38) depths of columns say nothing
  uint first_range;  // where they begin in depth_ranges
};

#ifdef __cplusplus
SHARED_LAYOUT(ClusterParams, lights, decals, probes, columns, rows, slices, near_plane, first_range);
SHARED_LAYOUT(Outline, nearest, farthest, planes);
#endif
SHARED_END
#endif
