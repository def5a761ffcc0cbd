// Parameters of the list of tiles that have decals.
#ifndef DECAL_TILES_LAYOUT_H
#define DECAL_TILES_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/formats/decal_tiles.h"
#include "harness/formats/scene.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(decal_tiles)

struct DecalTileParams {
  uint width;  // pixels, 1 to 16,384
  uint height;
  uint first_range;  // where the ranges of 16x16 pixels begin in the depth pyramid
  ClusterGrid grid;  // of a column, a row and a slice at least
};

#ifdef __cplusplus
SHARED_LAYOUT(DecalTileParams, width, height, first_range, grid);
#endif
SHARED_END
#endif
