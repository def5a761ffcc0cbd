// A pixel walks all lights.
// Loop turns of an invocation: 32,768, and with shadows 28,672.
#include "kernels/deferred_lighting/common.glsl"

void add_lights(inout Lit lit, uvec2 pixel, float d) {
#ifdef SHADOWED
  const uint count = min(light_count(), kMostShadowedLights);
#else
  const uint count = light_count();
#endif
#ifdef MUTANT_7  // the last light is left out
  for (uint i = 0u; i + 1u < count; ++i) lit.radiance += lit_by(lit, lights[i]);
#else
  for (uint i = 0u; i < count; ++i) lit.radiance += lit_by(lit, lights[i]);
#endif
}
