// Parameters of the cluster lists, and what they tell of themselves.
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

// What is asked for, were there room for all, and what is in no list.
struct ListStatus {
  uint entries;
  uint dropped_lights;
  uint dropped_decals;
  uint dropped_probes;
};

#ifdef __cplusplus
SHARED_LAYOUT(ListParams, lights, decals, probes, cells, capacity);
SHARED_LAYOUT(ListStatus, entries, dropped_lights, dropped_decals, dropped_probes);
#endif
SHARED_END
#endif
