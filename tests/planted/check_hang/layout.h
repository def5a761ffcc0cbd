#ifndef CHECK_HANG_LAYOUT_H
#define CHECK_HANG_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(check_hang)

struct HangParams {
  uint count;
  uint turns;  // of the outer loop; as many of the inner one in each
};

#ifdef __cplusplus
SHARED_LAYOUT(HangParams, count, turns);
#endif
SHARED_END
#endif
