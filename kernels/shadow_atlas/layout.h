// Parameters of the draws into the shadow atlas.
#ifndef SHADOW_ATLAS_LAYOUT_H
#define SHADOW_ATLAS_LAYOUT_H
#include "harness/formats/material.h"
#include "harness/formats/scene.h"
#include "harness/formats/shadow.h"
#include "harness/shared.h"
SHARED_BEGIN(shadow_atlas)

struct ShadowAtlasParams {
  SceneCounts scene;
  ShadowCounts shadows;
};

// Clip coordinates whose magnitudes sum to this or more, and those that are no numbers, are taken for kNowhere's.
SHARED_CONST float kFarthest = 1.267650600228229401496703205376e30f;  // 2^100

#ifdef __cplusplus
SHARED_LAYOUT(ShadowAtlasParams, scene, shadows);
#endif
SHARED_END
#endif
