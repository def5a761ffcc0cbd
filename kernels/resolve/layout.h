#ifndef RESOLVE_LAYOUT_H
#define RESOLVE_LAYOUT_H
#include "harness/formats/exposure.h"
#include "harness/shared.h"
SHARED_BEGIN(resolve)

// How the exposure is found.
SHARED_CONST uint kMeterManual = 0u;   // it is given
SHARED_CONST uint kMeterMean = 1u;     // from the mean luminance
SHARED_CONST uint kMeterLogMean = 2u;  // from the mean of log2 luminance; so does any other value

struct ResolveParams {
  uint width;  // pixels
  uint height;
  uint metering;          // kMeter...
  float manual_exposure;  // with kMeterManual: what radiance is multiplied by
  float compensation;     // multiplies any exposure: 2^stops
};

// Of a group's pixels, or of all: sum of luminance, or of its log2.
struct PartialSum {
  float sum;
  uint counted;
};

// Weights of Rec. 709, whose primaries sRGB has.
SHARED_CONST float kLuminanceRed = 0.2126f;
SHARED_CONST float kLuminanceGreen = 0.7152f;
SHARED_CONST float kLuminanceBlue = 0.0722f;

SHARED_CONST float kMiddleGrey = 0.18f;                 // what the mean is brought to
SHARED_CONST float kLeastMean = 6.103515625e-5f;        // 2^-14: a black picture is not amplified without end
SHARED_CONST float kGreatestMean = 65536.0f;            // 2^16
SHARED_CONST float kLeastLuminance = 3.0517578125e-5f;  // 2^-15: for its logarithm, darker pixels are as bright as this

SHARED_CONST uint kThreadPixels = 8u;   // a side, in threads of the sums
SHARED_CONST uint kBlockPixels = 128u;  // a side, in groups of 16x16 threads
SHARED_CONST uint kSmallBlock = 16u;    // a side, in groups of sequential_groups

#ifdef __cplusplus
SHARED_LAYOUT(ResolveParams, width, height, metering, manual_exposure, compensation);
SHARED_LAYOUT(PartialSum, sum, counted);
#endif
SHARED_END
#endif
