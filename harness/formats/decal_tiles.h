// The list of screen tiles that have decals: tiles of 16x16 pixels, numbered in rows as those of variable-rate shading
// are (formats/vrcs.h).
#ifndef FORMATS_DECAL_TILES_H
#define FORMATS_DECAL_TILES_H
#include "harness/formats/vrcs.h"
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kDecalTileSide = kVrcsTileSide;
SHARED_CONST float kLeastDecalDepth = 1e-18f;  // of reversed depth: what is less, or no number, is no surface

SHARED_END
#endif
