// What both variants bind, and whether a cell lists a decal.
#include "harness/glsl/ports.glsl"
#include "kernels/decal_tiles/layout.h"
#include "harness/glsl/tiles.glsl"

READS(0, float, slice_edges);
READS(1, uvec2, cells);
WRITES(2, uint, tiles);
UPDATES(3, uint, count);
PARAMS(DecalTileParams);

#include "harness/glsl/clusters.glsl"
#include "harness/glsl/decal_tiles.glsl"

bool lists_decal(uint cell) {
#ifdef MUTANT_1  // a cell that lists anything
  return cells[cell].y != 0u;
#else
  return (cells[cell].y >> kClusterDecalShift & kClusterItemMask) != 0u;
#endif
}

uint all_tiles() { return count_decal_tiles(params.width, params.height); }
