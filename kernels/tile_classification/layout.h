// Parameters of the tile classification; the structs that other kernels read are in harness/formats/workloads.h.
#ifndef TILE_CLASSIFICATION_LAYOUT_H
#define TILE_CLASSIFICATION_LAYOUT_H
#include "harness/formats/scene.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(tile_classification)

struct ClassifyParams {
  uint width;  // pixels
  uint height;
  uint workloads;             // rows of the table; above kMaxWorkloads counts as kMaxWorkloads
  uint passes;                // above kMaxPasses counts as kMaxPasses; rows of other passes take no tile
  uint groups_per_tile;       // workgroups that shade a tile; above kMaxGroups counts as kMaxGroups
  uint relevant[kMaxPasses];  // a pass wants the tiles with any of these bits; kEveryFeature: all that are not empty
};

SHARED_CONST uint kNoWorkload = 0xffffffffu;

#ifdef __cplusplus
SHARED_LAYOUT(ClassifyParams, width, height, workloads, passes, groups_per_tile, relevant);
#endif
SHARED_END
#endif
