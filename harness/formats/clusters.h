// Convex items, the grid of cells they are sorted into, and the slices of depth; view space, x right, y down, z
// forward.
#ifndef HARNESS_FORMATS_CLUSTERS_H
#define HARNESS_FORMATS_CLUSTERS_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kMaxClusterLights = 4096u;
SHARED_CONST uint kMaxClusterDecals = 4096u;
SHARED_CONST uint kMaxClusterProbes = 256u;
SHARED_CONST uint kMaxClusterColumns = 120u;  // of 32 pixels at 3840x2160
SHARED_CONST uint kMaxClusterRows = 68u;
SHARED_CONST uint kMaxClusterSlices = 32u;

SHARED_CONST uint kShapeBox = 0u;  // origin ± a ± b ± c
SHARED_CONST uint kShapePyramid =
    1u;  // the hull of origin, the apex, and origin + c ± a ± b; every other value is a box

// Metres. Any three vectors will do: skew, flat and empty shapes are shapes. A number of 2^38 or more, infinite or not
// a number, in any of them takes the item out of all cells.
struct ClusterItem {
  vec3 origin;
  uint shape;
  vec3 a;
  vec3 b;
  vec3 c;
};

// Cells of a picture: pixel (x, y) at depth z is in column x / cell_width, row y / cell_height, and the last slice that
// begins at z or nearer; what is nearer than the first or farther than the last is in those. Cells follow one another
// by column, row and slice.
struct ClusterGrid {
  uint columns;
  uint rows;
  uint slices;
  uint cell_width;  // pixels
  uint cell_height;
};

#ifdef __cplusplus
SHARED_LAYOUT(ClusterGrid, columns, rows, slices, cell_width, cell_height);
SHARED_LAYOUT(ClusterItem, origin, shape, a, b, c);
#endif
SHARED_END
#endif
