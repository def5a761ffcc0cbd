#ifndef DEFERRED_LIGHTING_LAYOUT_H
#define DEFERRED_LIGHTING_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/formats/lighting.h"
#include "harness/formats/shadow.h"
#include "harness/shared.h"
SHARED_BEGIN(deferred_lighting)

struct LightingParams {
  ViewRays rays;
  float near_plane;  // metres
  vec3 ambient;      // radiance that comes from everywhere
  uint width;        // pixels
  uint height;
  uint lights;  // records; those past kMostLights are not looked at
  // Of the variants that walk lists.
  ClusterGrid grid;
  uint entries;  // of the lists
  // Of the variants that shade primaries, and of those with shadows.
  uint frame;  // as the lists of primaries were made with
  // Of the variants with shadows.
  uint shadow_views;
  uint shadow_width;  // of the atlas, texels
  uint shadow_height;
};

// One loop of an invocation runs over them, and lavapipe ends loops after 65,535 turns.
SHARED_CONST uint kMostLights = 32768u;
SHARED_CONST uint kMostShadowedLights = 2048u;  // of all lights with shadows, whose lookups take 13 turns each

// Below this length, of pixels at distance 1, a plane has no normal.
SHARED_CONST float kLeastArea = 1e-15f;

#ifdef __cplusplus
SHARED_LAYOUT(LightingParams, rays, near_plane, ambient, width, height, lights, grid, entries, frame, shadow_views,
              shadow_width, shadow_height);
#endif
SHARED_END
#endif
