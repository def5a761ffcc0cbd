#ifndef CHECK_TARGETS_LAYOUT_H
#define CHECK_TARGETS_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(check_targets)

struct TargetParams {
  uint width;
  uint hole;  // the pixel, row by row, that no fragment covers
};

SHARED_CONST uint kClearColour = 9u;
SHARED_CONST float kDepth = 0.25;  // of every fragment

#ifdef __cplusplus
SHARED_LAYOUT(TargetParams, width, hole);
#endif
SHARED_END
#endif
