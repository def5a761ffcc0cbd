// Tiles that have decals (harness/formats/decal_tiles.h): where they lie, and which pixels take decals.
#ifndef HARNESS_GLSL_DECAL_TILES
#define HARNESS_GLSL_DECAL_TILES
#include "harness/formats/decal_tiles.h"

uint decal_tiles_across(uint width) { return (width + kDecalTileSide - 1u) / kDecalTileSide; }
uint count_decal_tiles(uint width, uint height) { return decal_tiles_across(width) * decal_tiles_across(height); }
uvec2 first_of_decal_tile(uint tile, uint width) {
  const uint across = decal_tiles_across(width);
  return uvec2(tile % across, tile / across) * kDecalTileSide;
}

// Whether something that decals lie on is at this reversed depth. Integers compare NaN too.
bool takes_decals(float depth) {
  const uint bits = floatBitsToUint(depth);
  return bits >= floatBitsToUint(kLeastDecalDepth) && bits < 0x7f800000u;
}
#endif
