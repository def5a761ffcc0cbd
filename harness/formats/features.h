// Feature bits of a pixel, and of the 32x32 tile that it touches (Lazarek, Hammer 2025, tile classification).
#ifndef FORMATS_FEATURES_H
#define FORMATS_FEATURES_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kTileSide = 32u;  // pixels

SHARED_CONST uint kFeatureOpaque = 1u << 0;  // any deferred surface
SHARED_CONST uint kFeatureMasked = 1u << 1;
SHARED_CONST uint kFeatureDoubleSided = 1u << 2;
SHARED_CONST uint kFeatureCloth = 1u << 3;
SHARED_CONST uint kFeatureSkin = 1u << 4;
SHARED_CONST uint kFeatureDecals = 1u << 5;
SHARED_CONST uint kFeatureWetnessDrops = 1u << 6;
SHARED_CONST uint kFeaturePuddles = 1u << 7;
SHARED_CONST uint kFeatureCaustics = 1u << 8;
SHARED_CONST uint kFeatureSubsurface = 1u << 9;
SHARED_CONST uint kFeatureReflective = 1u << 10;
SHARED_CONST uint kFeatureEmissive = 1u << 11;
SHARED_CONST uint kFeatureTextured = 1u << 12;

SHARED_END
#endif
