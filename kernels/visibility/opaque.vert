#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "kernels/visibility/pull.glsl"

layout(location = 0) flat out uint word;

void main() {
  uint surface = surface_index();
  gl_Position = clip_position(surface, vertex_index());
  word = surface_word(surface);
}
