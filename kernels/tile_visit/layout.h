// Parameters of the visit of tile lists.
#ifndef TILE_VISIT_LAYOUT_H
#define TILE_VISIT_LAYOUT_H
#include "harness/formats/scene.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(tile_visit)

SHARED_CONST uint kMaxVisitors = 8u;  // workloads; each counts its visits of a pixel in 4 bits

struct VisitParams {
  uint width;  // pixels
  uint height;
  uint workloads;  // above kMaxVisitors counts as kMaxVisitors
};

#ifdef __cplusplus
SHARED_LAYOUT(VisitParams, width, height, workloads);
#endif
SHARED_END
#endif
