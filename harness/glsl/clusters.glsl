// The cell of a pixel (harness/formats/clusters.h). Before including, a shader declares `slice_edges`: the slices'
// boundaries in reversed depth, descending, slices + 1 of them (harness/clusters.h).
#ifndef HARNESS_GLSL_CLUSTERS
#define HARNESS_GLSL_CLUSTERS
#include "harness/formats/cluster_lists.h"
#include "harness/formats/clusters.h"

// How many boundaries the reversed depth d is at or beyond, less one; before the first it is in the first. No arithmetic
// on depths: culler and shader cannot disagree. NaN is in the first. Turns: 5 of 32 slices.
uint slice_of(ClusterGrid grid, float d) {
  uint low = 0u, high = max(grid.slices, 1u);
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
#ifdef MUTANT_9401  // < for <= : a depth on a boundary is in the slice before
    if (d < slice_edges[middle])
#else
    if (d <= slice_edges[middle])
#endif
      low = middle;
    else
      high = middle;
  }
  return low;
}

// The column and row of a pixel; beyond the grid's last, that. The grid has a column, a row and a slice at least.
uvec2 column_row_of(ClusterGrid grid, uvec2 pixel) {
  const uvec2 size = max(uvec2(grid.cell_width, grid.cell_height), uvec2(1u));
#ifdef MUTANT_9402  // columns of the rows' height
  return min(pixel / size.y, uvec2(grid.columns - 1u, grid.rows - 1u));
#else
  return min(pixel / size, uvec2(grid.columns - 1u, grid.rows - 1u));
#endif
}

uint cell_of(ClusterGrid grid, uvec2 pixel, float d) {
  const uvec2 at = column_row_of(grid, pixel);
  return (slice_of(grid, d) * grid.rows + at.y) * grid.columns + at.x;
}
#endif
