// A thread walks its own cell's list (harness/glsl/light_lists.glsl).
// Loop turns: 256.
#include "harness/glsl/light_lists.glsl"

void walk_own(inout Lit lit, List list) {
#ifdef MUTANT_9831  // the first is left out
  for (uint i = 1u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#else
  for (uint i = 0u; i < list.count; ++i) add_light(lit, light_in(list.first + i));
#endif
}
