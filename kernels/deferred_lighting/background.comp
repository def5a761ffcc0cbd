#version 460
// The pixels that no list of primaries holds: 8 bytes read of each, and only these written.
#include "kernels/deferred_lighting/covered.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
#ifdef MUTANT_25  // in whole groups alone
  if (gl_WorkGroupID.x * 16u + 16u > params.width) return;
#endif
  if (on_screen(pixel) && !is_covered(pixel)) store_background(pixel);
}
