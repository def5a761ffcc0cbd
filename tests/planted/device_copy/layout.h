// A buffer of pairs and the number of them.
#ifndef DEVICE_COPY_LAYOUT_H
#define DEVICE_COPY_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(device_copy)

struct CopyParams {
  uint count;
  uint add;
};
struct Pair {
  uint key;
  vec3 place;
  float weights[2];
};

#ifdef __cplusplus
SHARED_LAYOUT(CopyParams, count, add);
SHARED_LAYOUT(Pair, key, place, weights);
#endif
SHARED_END
#endif
