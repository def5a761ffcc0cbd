#ifndef CHECK_FAULTS_LAYOUT_H
#define CHECK_FAULTS_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(check_faults)

struct FaultParams {
  uint count;
};

struct Pair {
  uint key;  // 3 * value + 1
  float half_value;
};

#ifdef __cplusplus
SHARED_LAYOUT(FaultParams, count);
SHARED_LAYOUT(Pair, key, half_value);
#endif
SHARED_END
#endif
