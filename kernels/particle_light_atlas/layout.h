// Parameters of the particles' lighting.
#ifndef PARTICLE_LIGHT_ATLAS_LAYOUT_H
#define PARTICLE_LIGHT_ATLAS_LAYOUT_H
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"
#include "harness/formats/lighting.h"
#include "harness/formats/particle.h"
#include "harness/formats/scene.h"
#include "harness/formats/shadow.h"
#include "harness/shared.h"
SHARED_BEGIN(particle_light_atlas)

struct ParticleLightParams {
  uint side;  // of the atlas, texels
  uint particles;
  uint blocks;   // that the list has room for
  uint lights;   // records; those past kMostLights are not looked at
  vec3 ambient;  // radiance that comes from everywhere
  uint frame;
  // Of the variants that walk lists. A position relative to the camera is at pixel (column . p, row . p) / depth . p.
  vec3 column;
  vec3 row;
  vec3 depth;
  float near_plane;  // metres
  ClusterGrid grid;
  uint entries;  // of the lists
  // Of the variants with shadows.
  uint shadow_views;
  uint shadow_width;  // of the atlas, texels
  uint shadow_height;
};

// One loop of an invocation runs over them, and lavapipe ends loops after 65,535 turns.
SHARED_CONST uint kMostLights = 32768u;
SHARED_CONST uint kMostShadowedLights = 2048u;  // of all lights with shadows, whose lookups take 13 turns each
// A quad whose numbers are beyond this, or none, is taken for a point at the eye: ambient light alone reaches it.
SHARED_CONST float kMostReach = 1048576.0f;  // metres
SHARED_CONST float kMostPixel = 65535.0f;
// Of a light's luminance, what counts for the dominant direction.
SHARED_CONST float kMostWeight = 65504.0f;
// Rec. 709.
SHARED_CONST float kLuminanceRed = 0.2126f;
SHARED_CONST float kLuminanceGreen = 0.7152f;
SHARED_CONST float kLuminanceBlue = 0.0722f;

#ifdef __cplusplus
SHARED_LAYOUT(ParticleLightParams, side, particles, blocks, lights, ambient, frame, column, row, depth, near_plane,
              grid, entries, shadow_views, shadow_width, shadow_height);
#endif
SHARED_END
#endif
