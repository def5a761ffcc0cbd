#ifndef MATERIAL_FEATURES_LAYOUT_H
#define MATERIAL_FEATURES_LAYOUT_H
#include "harness/formats/material.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/shared.h"
SHARED_BEGIN(material_features)

struct FeatureParams {
  uint width;  // pixels
  uint height;
  uint surfaces;   // an index at or above it has no features
  uint materials;  // likewise
};

#ifdef __cplusplus
SHARED_LAYOUT(FeatureParams, width, height, surfaces, materials);
#endif
SHARED_END
#endif
