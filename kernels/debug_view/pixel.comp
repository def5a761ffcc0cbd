#version 460
// A thread a pixel.
#include "kernels/debug_view/paint.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
#ifdef MUTANT_7
  if (!on_screen(pixel + uvec2(1u, 0u), uvec2(params.width, params.height))) return;
#else
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
#endif
  image[pixel.y * params.width + pixel.x] = colour_of(visible_at(pixel));
}
