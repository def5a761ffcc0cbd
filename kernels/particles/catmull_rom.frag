#version 460
// Catmull and Rom 1974: through the texels, exact for parabolas; held within the inner four, so that a shadow's edge does
// not ring and nothing is negative.
#include "kernels/particles/atlas.glsl"

vec4 weights(float f) {
  return vec4(f * (f * (1.0 - 0.5 * f) - 0.5), 1.0 + f * f * (1.5 * f - 2.5), f * (0.5 + f * (2.0 - 1.5 * f)),
              f * f * (0.5 * f - 0.5));
}

vec3 filtered(LightRect r, ivec2 first, vec2 f) {
  const vec4 x = weights(f.x), y = weights(f.y);
  vec3 sum = vec3(0.0), least = vec3(kGreatestRadiance * 4.0), most = vec3(0.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const vec3 t = texel(r, first + ivec2(i - 1, j - 1));
      sum += x[i] * y[j] * t;
      if (i == 1 || i == 2)
        if (j == 1 || j == 2) least = min(least, t), most = max(most, t);
    }
#ifdef MUTANT_14  // it overshoots
  return sum;
#else
  return clamp(sum, least, most);
#endif
}
