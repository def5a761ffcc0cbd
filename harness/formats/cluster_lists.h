// What touches each cell of a grid (formats/clusters.h), as lists: of each cell where its entries begin and how many of
// each kind it has; the i-th entry of a cell names its i-th light, decal and probe at once, so a cell has as many
// entries as its longest kind. A cell's items ascend within their kind.
//
// cells      buffer of uvec2, a cell: x: its first entry; y: its counts
// entries    buffer of uint: numbers within their kinds; 0 where the cell has no i-th item of a kind
#ifndef HARNESS_FORMATS_CLUSTER_LISTS_H
#define HARNESS_FORMATS_CLUSTER_LISTS_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Of a cell; of more items of a kind the lowest stay. Of probes one less: their count has 8 bits.
SHARED_CONST uint kMaxClusterEntries = 256u;

// Of a cell's counts and of an entry alike: lights from bit 0, decals and probes above.
SHARED_CONST uint kClusterItemMask = 0xfffu;
SHARED_CONST uint kClusterDecalShift = 12u;
SHARED_CONST uint kClusterProbeShift = 24u;

// Entries that all cells ask for together, and how many items found no room in the list of a cell.
struct ClusterListStatus {
  uint entries;
  uint dropped_lights;
  uint dropped_decals;
  uint dropped_probes;
};

#ifdef __cplusplus
SHARED_LAYOUT(ClusterListStatus, entries, dropped_lights, dropped_decals, dropped_probes);
#else
// Lights, decals, probes.
uint pack_cluster(uvec3 v) { return v.x | v.y << kClusterDecalShift | v.z << kClusterProbeShift; }
uvec3 unpack_cluster(uint v) {
  return uvec3(v & kClusterItemMask, v >> kClusterDecalShift & kClusterItemMask, v >> kClusterProbeShift);
}
#endif

SHARED_END
#endif
