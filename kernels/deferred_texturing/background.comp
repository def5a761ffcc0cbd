#version 460
// The pixels that no list holds: 8 bytes read of each, and only these written.
#include "kernels/deferred_texturing/shade.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (on_screen(pixel) && look_of(visible_at(pixel).y).shader == kUnregistered) store_nothing(pixel);
}
