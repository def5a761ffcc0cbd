// A thread a texel walks the list of its cell.
#include "kernels/particle_light_atlas/common.glsl"
#include "kernels/particle_light_atlas/cells.glsl"
#include "harness/glsl/light_lists_own.glsl"

void add_lights(inout Lit lit, Texel t) {
  if (t.is_one) walk_own(lit, list_of(cell_at(lit.surface.position)));
}
