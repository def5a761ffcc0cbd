#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "kernels/visibility/pull.glsl"
READS(2, VertexAttributes, attributes);

layout(location = 0) flat out uint word;
layout(location = 1) flat out uint material;
layout(location = 2) out vec2 uv;

void main() {
  uint surface = surface_index();
  uint vertex = vertex_index();
  gl_Position = clip_position(surface, vertex);
  word = surface_word(surface);
  material = clamped(surfaces[surface].material, params.scene.materials);
#ifdef MUTANT_7
  uv = attributes[vertex].uv.yx;
#else
  uv = attributes[vertex].uv;
#endif
}
