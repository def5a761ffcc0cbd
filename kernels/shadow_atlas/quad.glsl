// Six vertices a tile, at depth 0.
#include "kernels/shadow_atlas/tile.glsl"

void main() {
  uint i = uint(gl_VertexIndex) / 6u, corner = uint(gl_VertexIndex) % 6u;
  gl_Position = kNowhere;
  ShadowTile t;
  if (!tile_at(i, t)) return;
#ifdef MUTANT_3
  uvec2 at = (uvec2(0x32u, 0x2cu) >> corner & 1u) * (t.side - 1u);
#else
  uvec2 at = (uvec2(0x32u, 0x2cu) >> corner & 1u) * t.side;
#endif
  gl_Position = vec4(2 * vec2(uvec2(t.x, t.y) + at) / vec2(params.shadows.width, params.shadows.height) - 1, 0, 1);
}
