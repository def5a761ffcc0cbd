// A group a tile, a lane a primary of its list. Lanes are numbered by subgroup, so that those without a primary are
// whole subgroups; widths from 4 to 128 fill the group exactly. Each lane also looks after a pixel of its own, in case
// that is background: where the tile's word does not say that there is none, 8 bytes are read of it.
#extension GL_KHR_shader_subgroup_basic : require
#define VRCS_TILES tiles
#define VRCS_ENTRIES tile_entries
READS(11, uint, tiles);
READS(12, uint, tile_entries);
#include "kernels/deferred_lighting/primaries.glsl"

layout(local_size_x = 256) in;

// Every cell is shaded once, for four pixels.
bool has_no_background(uint word) {
#ifdef MUTANT_20  // by the flag alone
  return (word & kVrcsTile2x2) != 0u;
#else
  return (word & kVrcsTile2x2) != 0u && (word & kVrcsTileCount) == kVrcsTileCells;
#endif
}

void main() {
  const uint tile = spread_group();
  if (tile >= vrcs_tile_count()) return;
  const uint lane = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
  const VrcsPixel p = vrcs_tile_pixel(tile, lane);
  if (!has_no_background(p.word)) {
    const uvec2 own = vrcs_own_pixel(tile, lane);
    const bool is_sky = p.code == kVrcsSky;
    if (on_screen(own) && (is_sky || !is_covered(own))) {
#ifdef MUTANT_21  // in sky tiles alone
      if (is_sky)
#endif
      store_background(own);
      if (p.code == kVrcsAll) return;
    }
  }
#ifdef MUTANT_22  // where all are to be shaded, none is
  if (p.code == kVrcsWork) shade_primary(p);
#else
  if (p.code == kVrcsAll || p.code == kVrcsWork) shade_primary(p);
#endif
}
