#ifndef BLENDED_LUMA_LAYOUT_H
#define BLENDED_LUMA_LAYOUT_H
#include "harness/formats/luma.h"
#include "harness/shared.h"
SHARED_BEGIN(blended_luma)

struct LumaParams {
  uint width;  // pixels
  uint height;
};

#ifdef __cplusplus
SHARED_LAYOUT(LumaParams, width, height);
#endif
SHARED_END
#endif
