// Tiles of the atlas, of the list TILES, TILE_COUNT long.
PARAMS(ShadowAtlasParams);
READS(2, ShadowTile, TILES);

// Before the near plane, so that a triangle of such vertices is cut away.
const vec4 kNowhere = vec4(0, 0, 2, 1);

// The i-th of the list, if there is one and it lies in the atlas.
bool tile_at(uint i, out ShadowTile t) {
  t = ShadowTile(0u, 0u, 0u);
#ifdef MUTANT_1
  if (TILE_COUNT == 0u) return false;
  t = TILES[min(i, TILE_COUNT - 1u)];
#else
  if (i >= TILE_COUNT) return false;
  t = TILES[i];
#endif
  uvec2 atlas = uvec2(params.shadows.width, params.shadows.height);
#ifdef MUTANT_2
  return t.side > 0u;
#else
  return t.side > 0u && all(lessThanEqual(uvec2(t.side), atlas)) &&
         all(lessThanEqual(uvec2(t.x, t.y), atlas - t.side));
#endif
}
