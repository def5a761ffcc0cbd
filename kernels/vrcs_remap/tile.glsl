// A group a tile. Lanes are numbered by subgroup: widths from 4 to 128 fill the group exactly.
#define VRCS_TILES tiles
#define VRCS_ENTRIES entries
#include "kernels/vrcs_remap/visit.glsl"

layout(local_size_x = 256) in;
layout(binding = 0) uniform utexture2D visibility;

bool has_surface(uvec2 pixel) { return texelFetch(visibility, ivec2(pixel), 0).xy != uvec2(kVisibilityNone); }

void main() {
  const uint tile = spread_group();
  if (tile >= vrcs_tile_count()) return;
#ifdef MUTANT_3  // lanes of a subgroup are not side by side in the list
  const uint lane = gl_SubgroupInvocationID * gl_NumSubgroups + gl_SubgroupID;
#else
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
#endif
  const VrcsPixel p = vrcs_tile_pixel(tile, lane);
#ifdef MUTANT_4  // sky is shaded
  if (p.code == kVrcsNoWork) return;
#else
  if (p.code == kVrcsSky || p.code == kVrcsNoWork) return;
#endif
  count_wave(tile);
#ifndef MUTANT_5  // where all are shaded, pixels without a surface are too
  if (p.code == kVrcsAll && !has_surface(p.at)) return;
#endif
#ifdef MUTANT_6  // depth is dropped
  vrcs_postfix(p, place_of(p.at));
#else
  vrcs_postfix(p, place_of(p.at) + p.depth * 2654435769u);
#endif
}
