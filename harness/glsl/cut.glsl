// Holes of masked materials.
#ifndef HARNESS_GLSL_CUT
#define HARNESS_GLSL_CUT
#define TEXTURES_SLOT 8
#include "harness/glsl/textures.glsl"
READS(3, MaterialRecord, materials);

bool is_hole(uint material, vec2 uv) {
  MaterialRecord m = materials[material];
  float alpha = m.base_colour.a * texture_at_level(m.base_texture, uv, 0).a;
#if defined(MUTANT_9501)
  return alpha <= m.alpha_cutoff;
#elif defined(MUTANT_9502)
  return false;
#elif defined(MUTANT_9503)
  return texture_at_level(m.base_texture, uv, 0).a < m.alpha_cutoff;
#else
  return alpha < m.alpha_cutoff;
#endif
}
#endif
