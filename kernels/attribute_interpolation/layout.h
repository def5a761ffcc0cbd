#ifndef ATTRIBUTE_INTERPOLATION_LAYOUT_H
#define ATTRIBUTE_INTERPOLATION_LAYOUT_H
#include "harness/formats/attributes.h"
#include "harness/formats/interpolation.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/shared.h"
SHARED_BEGIN(attribute_interpolation)

struct AttributeParams {
  uint width;  // pixels
  uint height;
  uint vertices;  // an index at or past one of these counts is taken for the last; where one is 0 there is no surface
  uint indices;
  uint surfaces;
  uint clip_samples;   // above 0, the second entry: pixel i is sample i, the visibility buffer is not looked at
  float probe_factor;  // kProbeFactor, kProbeAddend
  float probe_addend;
};

// The second entry: a triangle in clip space (x, y, w) seen at the centre of a pixel of a viewport. It has no
// attributes: normal +z, tangent +x.
struct ClipSample {
  vec3 v0;
  vec3 v1;
  vec3 v2;
  uvec2 pixel;     // below 2^23
  uvec2 viewport;  // pixels
};

// What is packed, before it is.
struct UnpackedAttributes {
  vec3 barycentrics;
  vec4 derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  vec3 normal;
  vec3 tangent;
};

// SurfaceAttributes of harness/glsl/attributes.glsl.
struct DecodedAttributes {
  vec3 barycentrics;
  vec3 d_dx;
  vec3 d_dy;
  vec3 normal;
  vec3 tangent;
  float handedness;
  uint front_facing;
};

// double_float: from this condition number on, where the half step of a stored weight is within the compensated
// formula's bound (README.md), the weights are worked out in pairs of floats.
SHARED_CONST float kWellConditioned = 64.0f;

#ifdef __cplusplus
SHARED_LAYOUT(AttributeParams, width, height, vertices, indices, surfaces, clip_samples, probe_factor, probe_addend);
SHARED_LAYOUT(ClipSample, v0, v1, v2, pixel, viewport);
SHARED_LAYOUT(UnpackedAttributes, barycentrics, derivatives, normal, tangent);
SHARED_LAYOUT(DecodedAttributes, barycentrics, d_dx, d_dy, normal, tangent, handedness, front_facing);
#endif
SHARED_END
#endif
