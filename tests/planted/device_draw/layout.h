// Triangles in a right-handed world with y up, seen from the origin along -z.
#ifndef DEVICE_DRAW_LAYOUT_H
#define DEVICE_DRAW_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(device_draw)

struct DrawParams {
  uint first;  // command, or vertex where there are none
  uint count;
  uint most;  // for the counted variant
};

SHARED_CONST uint kFrontBit = 0x100u;  // set in the colour of front faces; the rest is the instance

#ifdef __cplusplus
SHARED_LAYOUT(DrawParams, first, count, most);
#endif
SHARED_END
#endif
