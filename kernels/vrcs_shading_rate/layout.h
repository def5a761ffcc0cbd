// Parameters of the shading rates.
#ifndef VRCS_SHADING_RATE_LAYOUT_H
#define VRCS_SHADING_RATE_LAYOUT_H
#include "harness/formats/vrcs.h"
#include "harness/shared.h"
SHARED_BEGIN(vrcs_shading_rate)

// What the study of pictures says: the most that is saved at a mean FLIP of 0.02 (README, Which estimator).
SHARED_CONST float kUsualTolerance = 0.02f;
SHARED_CONST float kUsualExtraHalf = 0.5f;

// In a frame whose resolution is dynamic (Fuller, Hammer 2025, for the shares; the slopes are ours): the tolerance is
// as asked for at 85 % of the display's height, by a third more at 50 %, less above; from 75 % down it grows in the
// corners, twofold at 50 %.
SHARED_CONST float kEvenShare = 0.85f;
SHARED_CONST float kToleranceSlope = 0.95f;
SHARED_CONST float kFoveatedShare = 0.75f;
SHARED_CONST float kFoveationSlope = 4.0f;
SHARED_CONST float kBorderGain = 2.0f;  // of the frame's border

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
