// A wave walks the lists of its cells together.
#include "kernels/particle_light_atlas/common.glsl"
#include "kernels/particle_light_atlas/cells.glsl"
#include "harness/glsl/light_lists_scalarised.glsl"

void add_lights(inout Lit lit, Texel t) { walk_together(lit, t.is_one ? cell_at(lit.surface.position) : kNothing); }
