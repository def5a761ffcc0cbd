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
SHARED_CONST uint kViewRate = 7u;      // how coarsely the cell of a pixel may be shaded
SHARED_CONST uint kViewPrimary = 8u;   // which pixels are shaded, and which copy them
SHARED_CONST uint kViewShadows = 9u;   // the shadow atlas: a colour a tile, brighter nearer to the light
SHARED_CONST uint kViewCount = 10u;

// Places of the colours of these two.
SHARED_CONST uint kColour1x1 = 0u;
SHARED_CONST uint kColour1x2 = 1u;
SHARED_CONST uint kColour2x1 = 2u;
SHARED_CONST uint kColour2x2 = 3u;
SHARED_CONST uint kColourPrimary = 4u;
SHARED_CONST uint kColourDuplicate = 5u;
SHARED_CONST uint kColourTileWhole = 6u;  // every covered pixel of the tile is shaded
SHARED_CONST uint kColourTile2x2 = 7u;    // one of each 2x2
SHARED_CONST uint kVrcsColours = 8u;

SHARED_END
#endif
