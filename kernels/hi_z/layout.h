// Parameters of the depth pyramid, and what a texel of it holds.
#ifndef HI_Z_LAYOUT_H
#define HI_Z_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(hi_z)

SHARED_CONST uint kMaxLevels = 14u;  // of 16,384 pixels a side

// Level k, from 1, has ceil(width / 2^k) x ceil(height / 2^k) texels, the last level, of at least one, 1 x 1. Levels
// lie one after another, rows tightly packed. Of a texel, x: least reversed depth, the farthest; y: greatest, the
// nearest.
struct HiZParams {
  uint width;  // pixels of the depth image, 1 to 16,384
  uint height;
};

#ifdef __cplusplus
SHARED_LAYOUT(HiZParams, width, height);
#endif
SHARED_END
#endif
