// A group a tile: counts it again, as the count did, and writes its entries. The tiles are walked backwards, so that what
// the count read last, and the cache may still hold, is read first.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/match.glsl"
#include "kernels/pixel_commands/place.glsl"
#if defined(STABLE)
#include "kernels/pixel_commands/write_stable.glsl"
#elif defined(MATCH_LANES)
#include "kernels/pixel_commands/write_lanes.glsl"
#else
#include "kernels/pixel_commands/write_runs.glsl"
#endif

void main() {
  const uint tile = tile_count(extent()) - 1u - spread_group();
  if (tile >= tile_count(extent())) return;  // the whole group: past the end it wraps
  clear_groups();
  clear_table();
  count_pixels(tile);
  place_groups(tile);
  write_pixels(tile);
  write_waves(tile);
  write_commands(tile);
}
