// Primaries are shaded, and what they come out as is copied. The includer says by which lights, add_lights(), and
// defines, before, the lists that it reads (harness/glsl/vrcs.glsl).
#include "harness/glsl/tiles.glsl"
#include "kernels/deferred_lighting/covered.glsl"
#define VRCS_EXTENT uvec2(params.width, params.height)
#define VRCS_RESULT vec4
#define VRCS_FRAME params.frame
#include "harness/glsl/vrcs.glsl"

void vrcs_store(uvec2 pixel, vec4 texel) { store(pixel, texel); }

// A primary without depth comes out as background, and so do its copies.
void shade_primary(VrcsPixel p) {
  const float d = depth_at(p.at);
#ifdef MUTANT_19  // it is left as it was
  if (d == 0.0) return;
#endif
  vec4 texel = kBackground;
  if (d != 0.0) {
    Lit lit = start(p.at, d);
    add_lights(lit, p.at, d);
    texel = texel_of(lit.radiance);
  }
  vrcs_postfix(p, texel);
}
