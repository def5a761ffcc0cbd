#version 460
// The uniform cubic B-spline, of the texels as they are: twice differentiable, and blurs.
#include "kernels/particles/atlas.glsl"

vec4 weights(float f) {
  const float g = 1.0 - f;
#ifdef MUTANT_13  // mirrored
  return vec4(f * f * f, 4.0 - 3.0 * g * g * (1.0 + f), 4.0 - 3.0 * f * f * (1.0 + g), g * g * g) / 6.0;
#else
  return vec4(g * g * g, 4.0 - 3.0 * f * f * (1.0 + g), 4.0 - 3.0 * g * g * (1.0 + f), f * f * f) / 6.0;
#endif
}

vec3 filtered(LightRect r, ivec2 first, vec2 f) {
  const vec4 x = weights(f.x), y = weights(f.y);
  vec3 sum = vec3(0.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) sum += x[i] * y[j] * texel(r, first + ivec2(i - 1, j - 1));
  return sum;
}
