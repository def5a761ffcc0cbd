// Parameters of the cluster voxelization.
#ifndef CLUSTER_VOXELIZATION_LAYOUT_H
#define CLUSTER_VOXELIZATION_LAYOUT_H
#include "harness/formats/clusters.h"
#include "harness/shared.h"
SHARED_BEGIN(cluster_voxelization)

SHARED_CONST uint kMaxPlanes = 6u;  // of an item

// Counts beyond those of formats/clusters.h count as these.
struct ClusterParams {
  uint lights;  // items 0 .. lights - 1; decals and probes follow
  uint decals;
  uint probes;
  uint columns;
  uint rows;
  uint slices;
};

#ifdef __cplusplus
SHARED_LAYOUT(ClusterParams, lights, decals, probes, columns, rows, slices);
#endif
SHARED_END
#endif
