#ifndef COPY_YARDSTICK_LAYOUT_H
#define COPY_YARDSTICK_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(copy_yardstick)

struct CopyParams {
  uint vectors;  // of 16 bytes
};

#ifdef __cplusplus
SHARED_LAYOUT(CopyParams, vectors);
#endif
SHARED_END
#endif
