// A pixel walks the lights of its cell.
#include "kernels/deferred_lighting/lists.glsl"
#include "harness/glsl/light_lists_own.glsl"

void add_lights(inout Lit lit, uvec2 pixel, float d) { walk_own(lit, list_of(cell_at(pixel, d))); }
