#ifndef RADIANCE_ENCODINGS_LAYOUT_H
#define RADIANCE_ENCODINGS_LAYOUT_H
#include "harness/formats/particle.h"
#include "harness/shared.h"
SHARED_BEGIN(radiance_encodings)

struct EncodingParams {
  uint colours;
};

#ifdef __cplusplus
SHARED_LAYOUT(EncodingParams, colours);
#endif
SHARED_END
#endif
