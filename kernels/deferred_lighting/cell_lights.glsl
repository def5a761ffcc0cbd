// A pixel walks the lights of its cell.
// Loop turns of an invocation: 256.
#include "kernels/deferred_lighting/lists.glsl"

void add_lights(inout Lit lit, uvec2 pixel, float d) {
  const List list = list_of(cell_at(pixel, d));
#ifdef MUTANT_15  // the first is left out
  for (uint i = 1u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#else
  for (uint i = 0u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#endif
}
