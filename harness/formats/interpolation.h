// Limits of the interpolation of a triangle at a pixel (harness/glsl/interpolation), which shaders and oracles share.
#ifndef FORMATS_INTERPOLATION_H
#define FORMATS_INTERPOLATION_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Full accuracy is promised where the largest magnitude of a triangle's clip coordinates lies in 2^-100 .. 2^100;
// beyond, and where there is no area to divide by, weights are 1/3 and derivatives 0. Exponents as floats are biased by
// 127.
SHARED_CONST uint kSmallestExponent = 27u;
SHARED_CONST uint kLargestExponent = 227u;
SHARED_CONST float kSmallestArea = 7.8886090522101181e-31f;  // 2^-100, of coordinates scaled to 1 .. 2

// Parameters of the kernel, so that the device works it out: factor * factor + addend is 2^-24 if multiply-add is
// fused, else 0.
SHARED_CONST float kProbeFactor = 1.000244140625f;  // 1 + 2^-12
SHARED_CONST float kProbeAddend = -1.00048828125f;  // -(1 + 2^-11)

SHARED_END
#endif
