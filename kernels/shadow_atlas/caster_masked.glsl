// A caster's vertex, and what its cut reads.
#include "kernels/shadow_atlas/caster.glsl"
READS(4, VertexAttributes, attributes);

layout(location = 1) flat out uint material;
layout(location = 2) out vec2 uv;

void main() {
  uint c = caster(), vertex = vertex_index();
  place(c, vertex);
  material = 0u;
  uv = vec2(0);
  if (bounds.zw == uvec2(0)) return;
  material = clamped(casters[c].material, params.scene.materials);
#ifdef MUTANT_11
  uv = attributes[vertex].uv.yx;
#else
  uv = attributes[vertex].uv;
#endif
}
