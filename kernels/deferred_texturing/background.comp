#version 460
// The pixels that no list holds: 8 bytes read of each, and only these written.
#include "kernels/deferred_texturing/store.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
#ifdef MUTANT_29  // only the sky is background
  if (on_screen(pixel) && visible_at(pixel).surface == kVisibilitySurfaceMask) store_nothing(pixel);
#else
  if (on_screen(pixel) && look_of(visible_at(pixel).surface).shader == kUnregistered) store_nothing(pixel);
#endif
}
