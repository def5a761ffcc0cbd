// A group a tile. Lanes are numbered by subgroup: widths from 4 to 128 fill the group exactly.
READS(4, uint, tiles);
READS(5, uint, entries);
#define VRCS_TILES tiles
#define VRCS_ENTRIES entries
#include "kernels/vrcs_remap/visit.glsl"

layout(local_size_x = 256) in;

void main() {
  const uint tile = spread_group();
  if (tile >= vrcs_tile_count()) return;
#ifdef MUTANT_6  // lanes of a subgroup are not side by side in the list
  const uint lane = gl_SubgroupInvocationID * gl_NumSubgroups + gl_SubgroupID;
#else
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
#endif
  visit(vrcs_tile_pixel(tile, lane), tile);
}
