#version 460
// As tiles, for the primaries of variable-rate shading: what one comes out as goes to its copies, which had its material
// before (harness/glsl/vrcs.glsl).
#extension GL_KHR_shader_subgroup_basic : require
#include "kernels/decal_atlas_sampling/listed.glsl"
READS(13, uint, vrcs_tiles);
READS(14, uint, vrcs_entries);
#define VRCS_TILES vrcs_tiles
#define VRCS_ENTRIES vrcs_entries
#define VRCS_EXTENT uvec2(params.width, params.height)
#define VRCS_RESULT Texels
#define VRCS_FRAME params.frame
#include "harness/glsl/vrcs.glsl"

void vrcs_store(uvec2 pixel, Texels t) {
#ifdef MUTANT_21  // normals are not stored
  if (t.touched.x) imageStore(base_roughness, ivec2(pixel), uvec4(t.base_roughness));
#else
  store_texels(pixel, t);
#endif
}

void main() {
  const uint tile = listed_tile();
  if (tile == kNoTile) return;
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
#ifdef MUTANT_22  // the place in the list taken for the tile
  const VrcsPixel p = vrcs_tile_pixel(spread_group(), lane);
#else
  const VrcsPixel p = vrcs_tile_pixel(tile, lane);
#endif
#ifdef MUTANT_23  // tiles that are shaded whole are left out
  if (p.code != kVrcsWork) return;
#else
  if (p.code == kVrcsSky || p.code == kVrcsNoWork) return;
#endif
  Material m;
#ifdef MUTANT_24  // nothing is copied
  if (decals_walked(p.at, m)) store_material(p.at, m);
#else
  if (decals_walked(p.at, m)) vrcs_postfix(p, texels_of(m));
#endif
}
