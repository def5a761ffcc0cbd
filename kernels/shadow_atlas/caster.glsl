// A caster's vertex in its tile of the list TILES.
#include "harness/glsl/clip.glsl"
#include "kernels/shadow_atlas/tile.glsl"
READS(0, vec3, positions);
READS(1, ShadowCaster, casters);

layout(location = 0) flat out uvec4 bounds;  // of the tile: first texel and end
out float gl_ClipDistance[4];                // from its four sides

uint vertex_index() { return clamped(uint(gl_VertexIndex), params.scene.vertices); }

// gl_InstanceIndex begins at the command's first_instance, so it is the caster itself.
uint caster() {
#ifdef MUTANT_4
  return clamped(uint(gl_BaseInstance), params.shadows.casters);
#else
  return clamped(uint(gl_InstanceIndex), params.shadows.casters);
#endif
}

// From -w..w within the tile to -w..w within the atlas. Where the atlas has a power of two of texels a side, the factors
// are exact.
float in_atlas(float v, float w, uint first, uint side, uint size) {
#ifdef MUTANT_5
  float offset = float(2 * int(first) - int(size)) / float(size);
#else
  float offset = float(int(2u * first + side) - int(size)) / float(size);
#endif
  precise float at = v * (float(side) / float(size)) + w * offset;
  return at;
}

void place(uint c, uint vertex) {
  gl_Position = kNowhere;
  for (uint i = 0u; i < 4u; ++i) gl_ClipDistance[i] = 1;
  bounds = uvec4(0);
  ShadowTile t;
  if (params.shadows.casters == 0u || params.scene.vertices == 0u || !tile_at(casters[c].tile, t)) return;
#ifdef MUTANT_6
  bounds = uvec4(t.x, t.y, t.x + t.side - 1u, t.y + t.side);
#else
  bounds = uvec4(t.x, t.y, t.x + t.side, t.y + t.side);
#endif
  vec3 p = positions[vertex];
#ifdef MUTANT_7
  float y = along(casters[c].clip_x, p);
#else
  float y = along(casters[c].clip_y, p);
#endif
  float x = along(casters[c].clip_x, p), z = along(casters[c].clip_z, p), w = along(casters[c].clip_w, p);
#ifndef MUTANT_8
  if (!(abs(x) + abs(y) + abs(z) + abs(w) < kFarthest)) return;  // NaN too
#endif
#ifdef MUTANT_9
  z *= 0.9999;
#endif
  gl_Position = vec4(in_atlas(x, w, t.x, t.side, params.shadows.width),
                     in_atlas(y, w, t.y, t.side, params.shadows.height), z, w);
#ifdef MUTANT_10
  gl_ClipDistance[0] = x;
#else
  gl_ClipDistance[0] = w + x;
#endif
  gl_ClipDistance[1] = w - x;
  gl_ClipDistance[2] = w + y;
  gl_ClipDistance[3] = w - y;
}
