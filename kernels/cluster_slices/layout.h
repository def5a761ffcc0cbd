#ifndef CLUSTER_SLICES_LAYOUT_H
#define CLUSTER_SLICES_LAYOUT_H
#include "harness/formats/clusters.h"
#include "harness/shared.h"
SHARED_BEGIN(cluster_slices)

struct SliceParams {
  uint first;         // the bits of the first depth; the others follow, past 2^32 - 1 at 0
  uint words;         // four depths each
  ClusterGrid grid;   // its slices
  float near_plane;   // of reversed depths, metres
  float first_slice;  // metres, where the first slice begins and the last ends, before rounding
  float last_slice;
};

#ifdef __cplusplus
SHARED_LAYOUT(SliceParams, first, words, grid, near_plane, first_slice, last_slice);
#endif
SHARED_END
#endif
