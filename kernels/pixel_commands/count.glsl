// A group a tile: the pixels and waves of each shader in it. Scans and offsets come later.
#include "kernels/pixel_commands/common.glsl"
#include "kernels/pixel_commands/pixels.glsl"
#include "kernels/pixel_commands/slots.glsl"
#include "kernels/pixel_commands/table.glsl"
#include "kernels/pixel_commands/match.glsl"
#include "kernels/pixel_commands/groups.glsl"

WRITES(3, TileCommands, tiles);

void main() {
  const uint all = tile_count(extent());
  const uint tile = spread_group();
  if (tile >= all) return;  // the whole group
  clear_groups();
  clear_table();
  count_pixels(tile);
  group_surfaces();
  for (uint s = gl_LocalInvocationID.x; s < shader_slots(); s += THREADS)
    tiles[s * all + tile] = TileCommands(shader_pixels[s], shader_waves[s], 0u, 0u);
}
