// Parameters of deferred texturing, and its outputs as the bounds see them.
#ifndef DEFERRED_TEXTURING_LAYOUT_H
#define DEFERRED_TEXTURING_LAYOUT_H
#include "harness/formats/gbuffer.h"
#include "harness/formats/interpolation.h"
#include "harness/formats/material.h"
#include "harness/formats/scene.h"
#include "harness/shared.h"
SHARED_BEGIN(deferred_texturing)

struct TexturingParams {
  uint width;  // pixels
  uint height;
  uint surfaces;
  uint materials;
  uint indices;
  uint vertices;
  uint shaders;                        // visible: slots
  uint waves;                          // that the pixel commands hold
  uint slot_of_class[kShaderClasses];  // kUnregistered: nothing shows the class
  float probe_factor;                  // kProbeFactor, kProbeAddend of formats/interpolation.h
  float probe_addend;
};

// Beyond these a coordinate or a gradient says nothing: a coordinate becomes 0, a gradient this much (the last level).
// NaN counts as beyond.
SHARED_CONST float kLargestUv = 65536.0f;
SHARED_CONST float kLargestGradient = 65536.0f;  // a pixel
// Heights mix over no less than this: under it, the lesser layer's share is lost to rounding.
SHARED_CONST float kLeastBlendDepth = 0.0009765625f;
SHARED_CONST float kLargestBlendDepth = 16.0f;
// A normal whose square is outside these has no direction that fp32 could tell: the surface's own takes its place.
SHARED_CONST float kLeastNormal = 1e-12f;
SHARED_CONST float kLargestNormal = 1e12f;
// What the base colour of an instance is multiplied by: between this and white.
SHARED_CONST vec3 kFoliageTint = vec3(0.7f, 0.85f, 0.6f);

#ifdef __cplusplus
SHARED_LAYOUT(TexturingParams, width, height, surfaces, materials, indices, vertices, shaders, waves, slot_of_class,
              probe_factor, probe_addend);
#endif
SHARED_END
#endif
