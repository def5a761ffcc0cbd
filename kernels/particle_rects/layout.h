// Parameters of the rectangles' allocation, and how large a particle's should be.
#ifndef PARTICLE_RECTS_LAYOUT_H
#define PARTICLE_RECTS_LAYOUT_H
#include "harness/formats/particle.h"
#include "harness/formats/scene.h"
#include "harness/shared.h"
SHARED_BEGIN(particle_rects)

struct RectParams {
  ParticleAtlas atlas;
  uint particles;    // records; those past kMostParticles are not looked at
  float pixels;      // of the picture, that a step of 1 across at distance 1 covers
  float near_plane;  // metres
  vec3 forward;      // unit
  // Planes through the eye along the picture's sides, normals inwards.
  vec3 left;
  vec3 right;
  vec3 top;
  vec3 bottom;
};

// The side of a square as large as the quad on the screen, in pixels times quality, from which on each size is wanted:
// a texel is 8 pixels at most, until there are 32.
SHARED_CONST float kLeastSide = 0.03125f;
SHARED_CONST float kSideOf16 = 64.0f;
SHARED_CONST float kSideOf32 = 128.0f;

// Numbers are held within these before they are reckoned with, so that no sum or product overflows, and none that
// matters is denormal.
SHARED_CONST float kLeastLength = 9.094947017729282e-13f;  // 2^-40; below: 0
SHARED_CONST float kMostAxis = 8192.0f;                    // metres, along an axis of space
SHARED_CONST float kMostDistance = 1048576.0f;             // metres
SHARED_CONST float kLeastDistance = 9.5367431640625e-7f;   // 2^-20
SHARED_CONST float kMostPixels = 131072.0f;                // pixels times quality

SHARED_CONST uint kNobody = 0xffffffffu;  // owns a slot

// Particles, and slots, are taken up in blocks, a group each.
SHARED_CONST uint kBlock = 256u;

#ifdef __cplusplus
SHARED_LAYOUT(RectParams, atlas, particles, pixels, near_plane, forward, left, right, top, bottom);
#endif
SHARED_END
#endif
