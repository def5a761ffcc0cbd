// Reads what attribute interpolation left of a pixel; formats/attributes.h has the encodings.
#ifndef HARNESS_GLSL_ATTRIBUTES
#define HARNESS_GLSL_ATTRIBUTES
#include "harness/formats/attributes.h"

struct SurfaceAttributes {
  vec3 barycentrics;  // perspective-correct weights of the triangle's vertices, sum 1
  vec3 d_dx;          // their derivatives, a pixel; sum 0
  vec3 d_dy;
  vec3 normal;  // world, unit length, on the side that the mesh says, whichever side is seen
  vec3 tangent;
  float handedness;  // bitangent = handedness * cross(normal, tangent)
  bool front_facing;
};

// Lambert's azimuthal equal-area projection of a hemisphere on the unit disc.
vec3 lambert_direction(uint code, bool negative) {
  const vec2 e = unpackSnorm2x16(code);
  const float r = min(dot(e, e), 1.0);
  return vec3(e * sqrt(2.0 - r), negative ? r - 1.0 : 1.0 - r);
}
vec3 half_direction(uint code, bool negative) {
  const vec2 xy = unpackHalf2x16(code);
  const float z = sqrt(max(1.0 - dot(xy, xy), 0.0));
  return normalize(vec3(xy, negative ? -z : z));
}

// d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy.
vec4 shared_exponent_derivatives(uvec2 word) {
  const int exponent = int(word.x >> 26 | (word.y >> 26 & 3u) << 6);
  const vec4 mantissas = vec4(bitfieldExtract(int(word.x), 0, 13), bitfieldExtract(int(word.x), 13, 13),
                              bitfieldExtract(int(word.y), 0, 13), bitfieldExtract(int(word.y), 13, 13));
  // As a float's own exponent: E - 139 is at least -112, at most 116.
  return exponent == 0 ? vec4(0) : mantissas * uintBitsToFloat(uint(exponent + 127 - kAttributeExponentBias) << 23);
}
vec4 half_derivatives(uvec2 word) { return vec4(unpackHalf2x16(word.x), unpackHalf2x16(word.y)); }

uint gathered_flags(uvec2 word, uint bit) {
  return (word.x >> bit & 1u) | (word.x >> (bit + 16u) & 1u) << 1 | (word.y >> bit & 1u) << 2 |
         (word.y >> (bit + 16u) & 1u) << 3;
}

SurfaceAttributes attributes_from(vec2 weights, vec4 derivatives, vec3 normal, vec3 tangent, uint flags) {
#ifdef MUTANT_9101
  derivatives = derivatives.xzyw;
#endif
#ifdef MUTANT_9102
  flags ^= kAttributeFrontFacing;
#endif
  return SurfaceAttributes(vec3(1.0 - weights.x - weights.y, weights),
                           vec3(-derivatives.x - derivatives.y, derivatives.xy),
                           vec3(-derivatives.z - derivatives.w, derivatives.zw), normal, tangent,
                           (flags & kAttributeLeftHanded) != 0u ? -1.0 : 1.0, (flags & kAttributeFrontFacing) != 0u);
}

// `encoding` is one of kAttributes...; a constant, so that the others cost nothing.
SurfaceAttributes decode_attributes_as(uint encoding, uint barycentrics, uvec2 derivatives, uvec2 tangent_frame) {
  if (encoding == kAttributesHalves) {
    const uint flags = gathered_flags(derivatives, 14u);
    return attributes_from(unpackHalf2x16(barycentrics), half_derivatives(derivatives & 0xbfffbfffu),
                           half_direction(tangent_frame.x, (flags & kAttributeNormalNegative) != 0u),
                           half_direction(tangent_frame.y, (flags & kAttributeTangentNegative) != 0u), flags);
  }
  const bool scaled = encoding == kAttributesHalfScaled;
  const uint flags = scaled ? gathered_flags(derivatives, 0u) : derivatives.y >> 28;
  const vec4 d = scaled ? half_derivatives(derivatives & 0xfffefffeu) / kAttributeHalfScale
                        : shared_exponent_derivatives(derivatives);
  return attributes_from(unpackUnorm2x16(barycentrics), d,
                         lambert_direction(tangent_frame.x, (flags & kAttributeNormalNegative) != 0u),
                         lambert_direction(tangent_frame.y, (flags & kAttributeTangentNegative) != 0u), flags);
}

// As the frame's default layout has them.
SurfaceAttributes decode_attributes(uint barycentrics, uvec2 derivatives, uvec2 tangent_frame) {
  return decode_attributes_as(kAttributesPacked, barycentrics, derivatives, tangent_frame);
}
#endif
