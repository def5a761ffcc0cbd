#version 460
// Dispatched once a workload, indirectly, over the tiles of its list: Lazarek and Hammer's picture of which shader runs where. The
// tile's pixels are shared among its groups, however many those are.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 32) in;
READS(4, uint, workload_tiles);
READS(5, WorkloadCount, workload_counts);
READS(6, uint, workload_colours);
ROW();

void main() {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint tiles = tile_count(extent);
  const uint entry = workload_entry();
  if (workload_colours[row] == 0u) return;  // of a pass that is not shown
#ifdef MUTANT_10
  if (entry > min(workload_counts[row].tiles, tiles - 1u)) return;
#else
  if (entry >= min(workload_counts[row].tiles, tiles)) return;
#endif
#ifdef MUTANT_11
  const uint tile = workload_tiles[entry];
#else
  const uint tile = workload_tiles[row * tiles + entry];
#endif
  if (tile >= tiles) return;
  const uint stride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
#ifdef MUTANT_12
  const uint end = stride;
#else
  const uint end = kTileSide * kTileSide;
#endif
  for (uint i = gl_WorkGroupID.x * gl_WorkGroupSize.x + gl_LocalInvocationID.x; i < end; i += stride) {
    const uvec2 pixel = pixel_of_tile(tile, i, params.width);
#ifdef MUTANT_13
    if (pixel.y >= params.height) continue;
#else
    if (!on_screen(pixel, extent)) continue;
#endif
    const uint scene = greyed(material_colour(visible_at(pixel)));
#ifdef MUTANT_14
    image[pixel.y * params.width + pixel.x] = blended(workload_colours[0], scene, 2u);
#else
    image[pixel.y * params.width + pixel.x] = blended(workload_colours[row], scene, 2u);
#endif
  }
}
