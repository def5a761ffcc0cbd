// A triangle in clip space as a pixel sees it, and what interpolation finds there. Formulas and their bounds:
// kernels/attribute_interpolation/README.md.
#ifndef HARNESS_GLSL_INTERPOLATION_TRIANGLE
#define HARNESS_GLSL_INTERPOLATION_TRIANGLE
#include "harness/formats/interpolation.h"
#include "harness/formats/scene.h"

struct Triangle {
  vec3 corners[3];   // clip x, y, w
  vec2 half_extent;  // of the viewport, pixels
  vec2 offset;       // of the pixel's centre from the viewport's; exact below 2^23 pixels
};

struct Interpolated {
  vec3 weights;
  vec4 derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  bool clockwise;    // on the screen, y down
};
Interpolated degenerate() { return Interpolated(vec3(1.0 / 3.0), vec4(0), false); }

// One of the clip rows, in the order and with the roundings of the visibility draw: coverage and weights then speak of
// the same triangle, to the bit.
float along(vec4 row, vec3 p) {
#ifdef MUTANT_9103  // the translation is left out
  precise float sum = row.x * p.x + row.y * p.y + row.z * p.z;
#else
  precise float sum = row.x * p.x + row.y * p.y + row.z * p.z + row.w;
#endif
  return sum;
}
vec3 corner_of(SurfaceRecord s, vec3 position) {
  return vec3(along(s.clip_x, position), along(s.clip_y, position), along(s.clip_w, position));
}

void place(inout Triangle t, uvec2 pixel, uvec2 viewport) {
  t.half_extent = 0.5 * vec2(viewport);
#ifdef MUTANT_9104  // the pixel's corner for its centre
  t.offset = vec2(pixel) - t.half_extent;
#else
  t.offset = vec2(pixel) + 0.5 - t.half_extent;
#endif
}

uint magnitude_bits(vec3 v) {
  const uvec3 bits = floatBitsToUint(v) & 0x7fffffffu;
  return max(max(bits.x, bits.y), bits.z);
}
// 2^-e for a number of magnitude bits in 2^e .. 2^(e+1); false for what is too small, too large, infinite or NaN.
bool scale_for(uint bits, out float scale) {
  const uint exponent = bits >> 23;
  scale = uintBitsToFloat((254u - exponent) << 23);
  return exponent >= kSmallestExponent && exponent <= kLargestExponent;
}
#endif
