#version 460
#include "kernels/deferred_lighting/lists.glsl"
#include "harness/glsl/light_lists_scalarised.glsl"

layout(local_size_x = 256) in;

void main() {
  const uvec2 pixel = gl_WorkGroupID.xy * 16u + in_tile(gl_LocalInvocationIndex);
  const float d = depth_at(pixel);
  const bool is_lit = d != 0.0;
  Lit lit;
  if (is_lit) lit = start(pixel, d);
  walk_together(lit, is_lit ? cell_at(pixel, d) : kNothing);
  if (!on_screen(pixel)) return;
  if (is_lit)
    store(pixel, texel_of(lit.radiance));
  else
    store_background(pixel);
}
