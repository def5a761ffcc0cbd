#version 460
// Each pixel walks all lights.
#include "kernels/deferred_lighting/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const float d = depth_at(pixel);
  if (d == 0.0) {
    store_background(pixel);
    return;
  }
  Lit lit = start(pixel, d);
  const uint count = light_count();
#ifdef MUTANT_7  // the last light is left out
  for (uint i = 0u; i + 1u < count; ++i) lit.radiance += shade(lit.surface, lights[i]);
#else
  for (uint i = 0u; i < count; ++i) lit.radiance += shade(lit.surface, lights[i]);
#endif
  store(pixel, lit.radiance);
}
