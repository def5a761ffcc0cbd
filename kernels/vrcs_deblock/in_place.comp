#version 460
// One image is read and written, as in the game: a neighbour that is a duplicate may be read before or after it changes.
// Only duplicates are stored.
#include "kernels/vrcs_deblock/deblock.glsl"

layout(binding = 6, rg32ui) uniform uimage2D radiance_in_place;

uvec2 texel_at(ivec2 pixel) { return imageLoad(radiance_in_place, pixel).rg; }
void store_texel(ivec2 pixel, uvec2 texel, bool changed) {
#ifndef MUTANT_17  // nothing is stored
  if (changed) imageStore(radiance_in_place, pixel, uvec4(texel, 0u, 0u));
#endif
}
bool belongs(ivec2 pixel, ivec2 neighbour) { return true; }
