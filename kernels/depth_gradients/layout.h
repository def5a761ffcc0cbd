// Parameters of the depth gradients.
#ifndef DEPTH_GRADIENTS_LAYOUT_H
#define DEPTH_GRADIENTS_LAYOUT_H
#include "harness/formats/interpolation.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/shared.h"
SHARED_BEGIN(depth_gradients)

struct GradientParams {
  uint width;  // pixels
  uint height;
  uint vertices;  // an index at or past one of these counts is taken for the last; where one is 0 there is no surface
  uint indices;
  uint surfaces;
  float probe_factor;  // kProbeFactor, kProbeAddend
  float probe_addend;
};

SHARED_CONST float kLargestGradient = 65504.0f;  // the largest half: what is beyond is this much
SHARED_CONST float kLeastDepth = 1e-18f;         // of reversed depth: what is less, or no number, is no surface

#ifdef __cplusplus
SHARED_LAYOUT(GradientParams, width, height, vertices, indices, surfaces, probe_factor, probe_addend);

// A pixel of the output, as it is judged.
struct Gradient {
  vec2 gradient;
};
SHARED_LAYOUT(Gradient, gradient);
#endif
SHARED_END
#endif
