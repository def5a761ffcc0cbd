// Punctual lights (glTF's KHR_lights_punctual), and the rays of a view.
#ifndef FORMATS_LIGHT_H
#define FORMATS_LIGHT_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kLightDirectional = 0u;
SHARED_CONST uint kLightPoint = 1u;
SHARED_CONST uint kLightSpot = 2u;

// Attenuation of point and spot lights: clamp(1 - (d / range)^4, 0, 1) / d^2; range 0 is unlimited. A spot's cone:
// clamp(cos(angle) * cone_scale + cone_offset, 0, 1)^2.
struct LightRecord {
  vec3 position;   // relative to the camera, metres; ignored of a directional one
  float range;     // metres
  vec3 colour;     // linear, times intensity: candela, or lux of a directional one
  uint kind;       // kLight...; any other sheds no light
  vec3 direction;  // unit, the way the light travels; of spots and directional ones
  float cone_scale;
  float cone_offset;
  // Its views in the shadow atlas (formats/shadow.h): none, one of a spot, six of a point light, a directional light's
  // cascades, nearest first.
  uint first_view;
  uint views;
};

// From a pixel and its reversed depth to the position relative to the camera: w = near / depth is the view depth, the
// position is w * (corner + across * x + down * y) with (x, y) the pixel's centre, in pixels.
struct ViewRays {
  vec3 corner;
  vec3 across;
  vec3 down;
};

#ifdef __cplusplus
SHARED_LAYOUT(LightRecord, position, range, colour, kind, direction, cone_scale, cone_offset, first_view, views);
SHARED_LAYOUT(ViewRays, corner, across, down);
#endif
SHARED_END
#endif
