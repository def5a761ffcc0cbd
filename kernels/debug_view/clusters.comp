#version 460
// The clusters view: how many items the pixel's cell lists. A thread a pixel.
#include "kernels/debug_view/common.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 4) uniform texture2D depth;
READS(5, uint, heat_colours);
READS(6, uvec2, cells);
READS(7, float, slice_edges);
#include "harness/glsl/clusters.glsl"

// A colour each doubling: 1, 2 to 3, 4 to 7 and so on; 0 is none.
uint heat_of(uint items) {
#ifdef MUTANT_20  // 1 is none too
  return items < 2u ? 0u : uint(findMSB(items));
#else
  return uint(findMSB(items) + 1);
#endif
}

uint cluster_colour(uvec2 pixel, uvec2 visible) {
  const uint scene = greyed(material_colour(visible));
  const ClusterGrid grid = params.grid;
  if (is_nothing(visible) || grid.columns == 0u || grid.rows == 0u) return blended(scene, kBackgroundColour, 1u);
  const uvec2 at = pixel % max(uvec2(grid.cell_width, grid.cell_height), uvec2(1u));
  if (at.x == 0u || at.y == 0u) return blended(scene, 0u, 1u);
  const uvec3 items = unpack_cluster(cells[cell_of(grid, pixel, texelFetch(depth, ivec2(pixel), 0).r)].y);
#ifdef MUTANT_21  // lights alone
  return blended(scene, heat_colours[heat_of(items.x)], 1u);
#else
  return blended(scene, heat_colours[heat_of(items.x + items.y + items.z)], 1u);
#endif
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel, uvec2(params.width, params.height))) return;
  image[pixel.y * params.width + pixel.x] = cluster_colour(pixel, visible_at(pixel));
}
