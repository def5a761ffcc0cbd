// A thread a texel walks all lights.
// Loop turns of an invocation: 32,768, and with shadows 13 of 2048 each.
#include "kernels/particle_light_atlas/common.glsl"

void add_lights(inout Lit lit, Texel t) {
  if (!t.is_one) return;
#ifdef SHADOWED
  const uint count = min(light_count(), kMostShadowedLights);
#else
  const uint count = light_count();
#endif
#ifdef MUTANT_10  // the last is left out
  for (uint i = 0u; i + 1u < count; ++i) add_light(lit, i);
#else
  for (uint i = 0u; i < count; ++i) add_light(lit, i);
#endif
}
