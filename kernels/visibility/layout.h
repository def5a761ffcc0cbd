// Parameters of the visibility draw, and the second 64 bits of its fat variant.
#ifndef VISIBILITY_LAYOUT_H
#define VISIBILITY_LAYOUT_H
#include "harness/formats/material.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/shared.h"
SHARED_BEGIN(visibility)

struct VisibilityParams {
  SceneCounts scene;
  float near_plane;  // metres; clip z of every vertex
};

// The fat texel. x: derivatives of the UV, 8 bits each, du/dx in the lowest byte, then dv/dx, du/dy, dv/dy: a sign bit
// over kFatCodes codes, code c > 0 standing for (4 + (c - 1) % 4) / 4 * 2^((c - 1) / 4 + kFatLowestExponent), 0 for
// zero. y: the normal, octahedral, 11 bits x and 11 bits y of [-1, 1] in steps of 1/1023; the tangent's angle about it,
// 9 bits of a full turn; the handedness, bit 31, set if negative.
SHARED_CONST uint kFatCodes = 127u;
SHARED_CONST int kFatLowestExponent = -21;
SHARED_CONST float kFatNormalSteps = 1023.0f;
SHARED_CONST float kFatTurnSteps = 512.0f;
SHARED_CONST uint kNegativeHand = 0x80000000u;

#ifdef __cplusplus
SHARED_LAYOUT(VisibilityParams, scene, near_plane);
#endif
SHARED_END
#endif
