// Which level of which layer is read.
#ifndef DEVICE_TEXELS_LAYOUT_H
#define DEVICE_TEXELS_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(device_texels)

struct TexelParams {
  uint width;  // of the level, texels
  uint height;
  uint layer;
  uint level;
};

#ifdef __cplusplus
SHARED_LAYOUT(TexelParams, width, height, layer, level);
#endif
SHARED_END
#endif
