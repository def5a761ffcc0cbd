// A pixel walks all lights.
// Loop turns of an invocation: 32,768.
#include "kernels/deferred_lighting/common.glsl"

void add_lights(inout Lit lit, uvec2 pixel, float d) {
  const uint count = light_count();
#ifdef MUTANT_7  // the last light is left out
  for (uint i = 0u; i + 1u < count; ++i) lit.radiance += shade(lit.surface, lights[i], 1.0);
#else
  for (uint i = 0u; i < count; ++i) lit.radiance += shade(lit.surface, lights[i], 1.0);
#endif
}
