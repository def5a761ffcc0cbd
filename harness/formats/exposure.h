// How radiance is shown: the exposure found for it, and the tone curve as tables (made by harness/tone_curve.h).
#ifndef FORMATS_EXPOSURE_H
#define FORMATS_EXPOSURE_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

struct ExposureRecord {
  float sum;
  uint counted;    // pixels with a surface whose radiance is finite
  float mean;      // luminance, whichever mean it is; with manual exposure all three are 0
  float exposure;  // what radiance is multiplied by
};

SHARED_CONST uint kCodes = 256u;

// Buckets of exposed radiance by a float's leading bits: 64 an octave from 2^-11 to 2^3, where all thresholds lie.
SHARED_CONST uint kBucketShift = 17u;
SHARED_CONST uint kFirstBucket = 0x3a000000u >> 17;  // 2^-11
SHARED_CONST uint kBuckets = 896u;

#ifdef __cplusplus
SHARED_LAYOUT(ExposureRecord, sum, counted, mean, exposure);
#endif
SHARED_END
#endif
