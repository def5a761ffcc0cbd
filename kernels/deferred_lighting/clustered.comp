#version 460
// Each pixel walks the lights of its cell.
// Loop turns of an invocation: 256.
#include "kernels/deferred_lighting/lists.glsl"

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
  const List list = list_of(cell_at(pixel, d));
#ifdef MUTANT_15  // the first is left out
  for (uint i = 1u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#else
  for (uint i = 0u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#endif
  store(pixel, lit.radiance);
}
