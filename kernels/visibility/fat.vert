#version 460
#include "harness/glsl/ports.glsl"
#include "kernels/visibility/layout.h"
#include "kernels/visibility/pull.glsl"
READS(2, VertexAttributes, attributes);

layout(location = 0) flat out uint word;
layout(location = 1) flat out uint material_and_hand;
layout(location = 2) out vec2 uv;
layout(location = 3) out vec3 normal;
layout(location = 4) out vec3 tangent;

void main() {
  uint surface = surface_index();
  uint vertex = vertex_index();
  gl_Position = clip_position(surface, vertex);
  word = surface_word(surface);
#ifdef MUTANT_12
  uv = attributes[vertex].uv.yx;
#else
  uv = attributes[vertex].uv;
#endif
  // Normals go by the cofactors of the transform, which turn them inside out where it mirrors.
  vec3 x = surfaces[surface].world_x.xyz, y = surfaces[surface].world_y.xyz, z = surfaces[surface].world_z.xyz;
#ifdef MUTANT_13
  float side = 1;
#else
  float side = (surfaces[surface].flags & kSurfaceFlipped) != 0u ? -1 : 1;
#endif
  vec3 n = attributes[vertex].normal;
  normal = side * vec3(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n));
  vec3 t = attributes[vertex].tangent.xyz;
  tangent = vec3(dot(x, t), dot(y, t), dot(z, t));
  uint material = clamped(surfaces[surface].material, params.scene.materials);
  material_and_hand = material | (side * attributes[vertex].tangent.w < 0 ? kNegativeHand : 0u);
}
