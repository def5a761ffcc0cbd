#ifndef MULTIPLY_ADD_YARDSTICK_LAYOUT_H
#define MULTIPLY_ADD_YARDSTICK_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(multiply_add_yardstick)

SHARED_CONST uint kGroupSize = 256u;
SHARED_CONST uint kRounds = 1024u;          // far below lavapipe's cap of 65,535 iterations an invocation
SHARED_CONST uint kOperationsARound = 32u;  // four chains of four lanes, a multiply and an add each

struct MultiplyAddParams {
  float factor;
  float term;
};

#ifdef __cplusplus
SHARED_LAYOUT(MultiplyAddParams, factor, term);
#endif
SHARED_END
#endif
