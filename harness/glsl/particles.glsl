// A particle's quad, and the words of its rectangle in the light atlas (harness/formats/particle.h).
#ifndef HARNESS_GLSL_PARTICLES
#define HARNESS_GLSL_PARTICLES
#include "harness/formats/particle.h"

struct LightRect {
  uvec2 corner;  // texels
  uint side;     // texels; 0: it has none
};
LightRect light_rect(uint word) {
  const uint size = word >> kRectSizeShift & kRectSizes;
  return LightRect(uvec2(word & kRectXBits, word >> kRectYShift & kRectXBits) * kLightBlockSide,
                   size == 0u ? 0u : 4u << size);
}
uint rect_word(uvec2 corner, uint size) {
  return corner.x / kLightBlockSide | corner.y / kLightBlockSide << kRectYShift | size << kRectSizeShift;
}

// Of a texel of a rectangle, where its centre is on the quad, along right and up: -1 to 1. Exact.
vec2 place_on_quad(uvec2 texel, uint side) { return vec2(2u * texel + 1u) / float(side) - 1.0; }

vec3 particle_position(ParticleRecord p, vec2 at) { return p.centre + p.right * at.x + p.up * at.y; }
#endif
