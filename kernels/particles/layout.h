#ifndef PARTICLES_LAYOUT_H
#define PARTICLES_LAYOUT_H
#include "harness/formats/lighting.h"
#include "harness/formats/particle.h"
#include "harness/shared.h"
SHARED_BEGIN(particles)

struct ParticlesParams {
  ViewRays rays;
  vec3 clip_x;  // rows of Vulkan's clip coordinates, of positions relative to the camera
  vec3 clip_y;
  vec3 clip_w;
  float near_plane;  // metres
  vec3 ambient;      // radiance that comes from everywhere
  uint particles;    // records
  uint drawn;        // entries of the order
  uint encoding;     // kLight... of the case's atlas; shaders see it decoded
  uint atlas_side;   // texels
  // Of the variants that light particles as they are drawn.
  uint lights;  // records; those past kMostLights are not looked at
};

// Of a number beyond this, or no number, in a place or an axis the particle is not drawn. Metres: products of three and
// a ray stay far from overflow.
SHARED_CONST float kFarthest = 1e6f;
// Both half axes must be this long at least, in one coordinate: shorter ones' products would be denormal.
SHARED_CONST float kSmallest = 1e-6f;
// Reversed depth: the farther, the nearer to 0; at or below this, and NaN, there is no surface.
SHARED_CONST float kLeastDepth = 1e-30f;
SHARED_CONST uint kMostLights = 32768u;  // lavapipe ends loops after 65,535 turns
SHARED_CONST uint kVertices = 6u;
SHARED_CONST uint kCorners = 4u;  // (-1, -1), (1, -1), (1, 1), (-1, 1) of right and up
SHARED_CONST uint kCornersGroup = 64u;

#ifdef __cplusplus
SHARED_LAYOUT(ParticlesParams, rays, clip_x, clip_y, clip_w, near_plane, ambient, particles, drawn, encoding,
              atlas_side, lights);
#endif
SHARED_END
#endif
