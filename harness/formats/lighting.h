// Constants of the shading model (harness/glsl/lighting.glsl) that shaders and oracles share.
#ifndef FORMATS_LIGHTING_H
#define FORMATS_LIGHTING_H
#include "harness/formats/features.h"
#include "harness/formats/gbuffer.h"
#include "harness/formats/light.h"
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST float kDielectricReflectance = 0.04f;  // at normal incidence, of an index of refraction of 1.5
// A light has a size: nearer than this it gets no brighter (Lagarde, de Rousiers 2014). Metres.
SHARED_CONST float kLeastLightDistance = 0.01f;
SHARED_CONST float kShortestVector = 1e-6f;       // vectors below this length are not made unit, but shorter
SHARED_CONST float kLeastNormalDotView = 1e-4f;   // interpolated normals may face away from the eye
SHARED_CONST float kGreatestRadiance = 65504.0f;  // the largest half

// What feature bits add, each to the diffuse lobe alone.
SHARED_CONST float kClothSheen = 0.5f;   // kFeatureCloth: share of the base colour that shines at grazing light
SHARED_CONST float kLeafThrough = 0.5f;  // kFeatureSubsurface: share of diffuse light that passes to the other side
SHARED_CONST float kSkinWrapRed = 0.4f;  // kFeatureSkin: how far past the terminator light reaches in thin skin, as a
SHARED_CONST float kSkinWrapGreen = 0.15f;  // cosine; red farthest
SHARED_CONST float kSkinWrapBlue = 0.1f;

SHARED_END
#endif
