// Parameters and receivers of the shadow lookup.
#ifndef SHADOW_LOOKUP_LAYOUT_H
#define SHADOW_LOOKUP_LAYOUT_H
#include "harness/formats/light.h"
#include "harness/formats/shadow.h"
#include "harness/shared.h"
SHARED_BEGIN(shadow_lookup)

struct LookupParams {
  uint receivers;
  uint lights;
  uint views;
  uint atlas_width;  // texels
  uint atlas_height;
};

// A point that may be in shadow.
struct Receiver {
  vec3 position;  // relative to the camera, metres
  uint light;     // past the end: none, whose share is 1
  vec3 plane_normal;
  float dither;
};

#ifdef __cplusplus
SHARED_LAYOUT(LookupParams, receivers, lights, views, atlas_width, atlas_height);
SHARED_LAYOUT(Receiver, position, light, plane_normal, dither);
#endif
SHARED_END
#endif
