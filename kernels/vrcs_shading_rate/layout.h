// Parameters of the shading rates.
#ifndef VRCS_SHADING_RATE_LAYOUT_H
#define VRCS_SHADING_RATE_LAYOUT_H
#include "harness/formats/vrcs.h"
#include "harness/shared.h"
SHARED_BEGIN(vrcs_shading_rate)

// What the study of pictures says: the most that is saved at a mean FLIP of 0.02 (README, Which estimator).
SHARED_CONST float kUsualTolerance = 0.02f;
SHARED_CONST float kUsualExtraHalf = 0.5f;

struct RateParams {
  uint width;  // pixels
  uint height;
  uint flags;            // kAllFull, kWeber
  float tolerance;       // error that passes: of luma 0..1, or with kWeber of the mean and `ambient` together
  float ambient;         // luma that the eye adapts to beside the mean's, kWeber only
  float half_weight;     // what motion makes of the squared error of 2x1 and 1x2; 1: nothing moves
  float quarter_weight;  // and of 2x2
  float extra_half;      // in ]0, 1[: 2x2 must pass with this share of the tolerance too, else it becomes a half rate
  float foveation;       // the tolerance grows to 1 + this in the picture's corners, with the square of the distance
  uint border;           // pixels from a side within which the tolerance is `border_gain` times as large
  float border_gain;
};

#ifdef __cplusplus
SHARED_LAYOUT(RateParams, width, height, flags, tolerance, ambient, half_weight, quarter_weight, extra_half, foveation,
              border, border_gain);
#endif
SHARED_END
#endif
