// Parameters of the cluster lists.
#ifndef CLUSTER_LISTS_LAYOUT_H
#define CLUSTER_LISTS_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/shared.h"
SHARED_BEGIN(cluster_lists)

SHARED_CONST uint kBlock = 256u;  // cells that are summed together
SHARED_CONST uint kMaxCells = kMaxClusterColumns * kMaxClusterRows * kMaxClusterSlices;

// Counts beyond those of formats/clusters.h, and cells beyond kMaxCells, count as these.
struct ListParams {
  uint lights;
  uint decals;
  uint probes;
  uint cells;     // columns * rows * slices
  uint capacity;  // entries that the list holds
};

#ifdef __cplusplus
SHARED_LAYOUT(ListParams, lights, decals, probes, cells, capacity);
#endif
SHARED_END
#endif
