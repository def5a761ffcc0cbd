// A group a tile of those that have decals, in an indirect dispatch over their list.
#include "kernels/decal_atlas_sampling/walk.glsl"
#include "harness/glsl/tiles.glsl"
READS(11, uint, decal_tiles);
READS(12, uint, decal_tile_count);

const uint kNoTile = 0xffffffffu;

// This group's tile; kNoTile for a group beyond the list, or where it names a tile that there is not.
uint listed_tile() {
  const uint all = count_decal_tiles(params.width, params.height), i = spread_group();
#ifdef MUTANT_18  // groups left over work on what lies behind the list
  if (i >= all) return kNoTile;
#else
  if (i >= min(decal_tile_count[0], all)) return kNoTile;
#endif
  const uint tile = decal_tiles[i];
#ifdef MUTANT_19  // tiles that there are not stand for others
  return tile % all;
#else
  return tile < all ? tile : kNoTile;
#endif
}
