#version 460
#include "kernels/particles/atlas.glsl"

vec3 filtered(LightRect r, ivec2 first, vec2 f) {
  const vec3 upper = mix(texel(r, first), texel(r, first + ivec2(1, 0)), f.x),
             lower = mix(texel(r, first + ivec2(0, 1)), texel(r, first + ivec2(1, 1)), f.x);
#ifdef MUTANT_12  // down by the fraction across
  return mix(upper, lower, f.x);
#else
  return mix(upper, lower, f.y);
#endif
}
