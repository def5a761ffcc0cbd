// What the frame's debug view shows of a pixel (Lazarek, Hammer 2025, debugging visualisations).
#ifndef FORMATS_DEBUG_VIEW_H
#define FORMATS_DEBUG_VIEW_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kViewMaterial = 0u;  // a colour a material
SHARED_CONST uint kViewTriangle = 1u;  // a colour a (surface, triangle)
SHARED_CONST uint kViewTile = 2u;      // the heat of a tile's features, with tile borders
SHARED_CONST uint kViewWorkload = 3u;  // the workload that shades the tile, over the dimmed material
SHARED_CONST uint kViewShader = 4u;    // a colour a shader class of deferred texturing
SHARED_CONST uint kViewWave = 5u;      // a colour a wave of the pixel lists
SHARED_CONST uint kViewClusters = 6u;  // how many items the cell of a pixel lists
SHARED_CONST uint kViewCount = 7u;

SHARED_END
#endif
