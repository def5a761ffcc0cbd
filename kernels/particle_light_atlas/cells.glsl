// The cell that a texel's position is in. Outside the picture, the picture's nearest; what is nearer than the near
// plane, or behind the eye, is looked up as if it lay there.
READS(8, uvec2, cells);
READS(9, uint, entries);
READS(10, float, slice_edges);
#include "harness/glsl/clusters.glsl"

uint cell_at(vec3 position) {
  const float depth = dot(params.depth, position), w = max(depth, params.near_plane);
  const vec2 at = vec2(dot(params.column, position), dot(params.row, position)) / w;
  const uvec2 pixel = uvec2(at.x > 0.0 ? min(at.x, kMostPixel) : 0.0, at.y > 0.0 ? min(at.y, kMostPixel) : 0.0);
#ifdef MUTANT_9  // all in the first slice
  return cell_of(params.grid, pixel, 3e38);
#else
  return cell_of(params.grid, pixel, params.near_plane / w);
#endif
}
