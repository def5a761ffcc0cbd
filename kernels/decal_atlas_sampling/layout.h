// Decals projected from an atlas.
#ifndef DECAL_ATLAS_SAMPLING_LAYOUT_H
#define DECAL_ATLAS_SAMPLING_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/formats/decal.h"
#include "harness/formats/decal_tiles.h"
#include "harness/formats/light.h"
#include "harness/formats/scene.h"
#include "harness/shared.h"
SHARED_BEGIN(decal_atlas_sampling)

struct DecalParams {
  uint width;  // pixels
  uint height;
  ClusterGrid grid;  // of a column, a row and a slice at least
  uint decals;
  uint entries;  // of the lists
  uint receivers;
  float near_plane;    // metres
  float atlas_border;  // texels of the first level around each rectangle that hold what it holds at its sides
  ViewRays rays;
  uint frame;  // that the lists of primaries were made with
};

SHARED_CONST float kLargestGradient = 65536.0f;  // of UV, a pixel: beyond it, or no number, this much
SHARED_CONST uint kAnisotropicTaps = 4u;
// A device's rho is at most sqrt(2) times the sum of both derivatives (Vulkan, Scale Factor Operation), and its level
// an eighth more at 4 bits of precision (2^(1/8)).
SHARED_CONST float kWidestRho = 1.5423f;
// And a tap may be off by a step of the filter's weights, a sixteenth of a texel at 4 bits: of half a texel, an eighth.
SHARED_CONST float kInset = 1.125f;
// A normal whose square is outside these has no direction that fp32 could tell: the surface's stays.
SHARED_CONST float kLeastNormal = 1e-6f;
SHARED_CONST float kLargestNormal = 1e12f;

#ifdef __cplusplus
SHARED_LAYOUT(DecalParams, width, height, grid, decals, entries, receivers, near_plane, atlas_border, rays, frame);
#endif
SHARED_END
#endif
