#version 460
// As gradient, on the tiles that have decals.
#include "kernels/decal_atlas_sampling/listed.glsl"

void main() {
  const uint tile = listed_tile();
  if (tile == kNoTile) return;
#ifdef MUTANT_20  // tiles as far apart as those of 32 pixels
  update_pixel(2u * first_of_decal_tile(tile, params.width) + gl_LocalInvocationID.xy);
#else
  update_pixel(first_of_decal_tile(tile, params.width) + gl_LocalInvocationID.xy);
#endif
}
