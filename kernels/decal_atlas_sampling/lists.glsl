// The decals of a cell as a list.
#ifndef DECAL_ATLAS_SAMPLING_LISTS
#define DECAL_ATLAS_SAMPLING_LISTS
#include "kernels/decal_atlas_sampling/blend.glsl"
READS(7, uvec2, cells);
READS(8, uint, entries);

struct List {
  uint at;   // in `entries`
  uint end;  // past the last
};

// What would lie past the end of `entries` is left out, and what is beyond kMaxClusterEntries.
List list_of(uint cell) {
  const uvec2 c = cells[cell];
  const uint count = min(c.y >> kClusterDecalShift & kClusterItemMask, kMaxClusterEntries);
  const uint first = min(c.x, params.entries);
#ifdef MUTANT_14  // the last decal of a cell is forgotten
  return List(first, first + min(max(count, 1u) - 1u, params.entries - first));
#else
  return List(first, first + min(count, params.entries - first));
#endif
}
uint decal_of(uint entry) { return entry >> kClusterDecalShift & kClusterItemMask; }
#endif
