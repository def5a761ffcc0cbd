// Parameters of the deblocker, and what is close to a pixel.
#ifndef VRCS_DEBLOCK_LAYOUT_H
#define VRCS_DEBLOCK_LAYOUT_H
#include "harness/formats/exposure.h"
#include "harness/formats/luma.h"
#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/shared.h"
SHARED_BEGIN(vrcs_deblock)

struct DeblockParams {
  uint width;  // pixels, 1 to 16,384
  uint height;
  uint frame;  // of tiles all 2x2: their cells' primary is the upper left pixel in even frames, the lower right in odd
};

// Depths are close whose bits are so many floats apart at most: a 16th of the power of two below them, 3 to 6 % of the
// distance.
SHARED_CONST uint kCloseDepths = 0x80000u;

#ifdef __cplusplus
SHARED_LAYOUT(DeblockParams, width, height, frame);
#endif
SHARED_END
#endif
