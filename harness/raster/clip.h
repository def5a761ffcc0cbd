// Vertices as the oracle of a draw knows them: exact positions, and how far a device may be from them. The bounds are
// derived in kernels/visibility/README.md, "Bounds". Host only.
#pragma once
#include "harness/oracle.h"
#include "harness/shared.h"

namespace assay::raster {

// Clip coordinates in double, and bounds of what an fp32 shader may compute for them.
struct ClipVertex {
  double x = 0, y = 0, z = 0, w = 0;
  double x_error = 0, y_error = 0, z_error = 0, w_error = 0;
  bool finite = true;
};
// dot(row, vec4(position, 1)), row by row.
struct Rows {
  vec4 x, y, z, w;
};
ClipVertex transform(const Rows&, const vec3& position);

// What the oracle knows of the target and of the device.
struct Target {
  double width = 0, height = 0;                     // pixels that clip coordinates span
  double left = 0, top = 0, right = 0, bottom = 0;  // what is drawn to: triangles are cut at these sides
  double grid = 256;                                // sub-pixel positions a pixel
};

// A corner in framebuffer coordinates, pixels, y down.
struct Corner {
  double x = 0, y = 0, inverse_w = 0;
  // The rasteriser's position lies within snap_x of snapped_x, likewise y: a grid point where only one is possible.
  double snapped_x = 0, snapped_y = 0, snap_x = 0, snap_y = 0;
  double moved = 0;           // how far from (x, y) it may be in either coordinate: pixels
  double relative_error = 0;  // of 1/w
  double z_error = 0;         // of depth, beside that of 1/w
};
// A vertex between the near and the far plane.
Corner corner_of(const ClipVertex&, const Target&);
// Where the edge from `inside`, at this distance from a plane (in clip coordinates, positive inside), to `outside`, at
// that negative one, meets the plane.
ClipVertex cut_vertex(const ClipVertex& inside, double distance, const ClipVertex& outside, double other);
// Rounding of a corner that clipping against a side plane puts on the edge a-b where 1/w is inverse_w: pixels, of 1/w
// (relative) and of depth beside it.
struct SideError {
  double moved = 0, relative = 0, depth = 0;
};
SideError side_error(const ClipVertex& a, const ClipVertex& b, double inverse_w, const Target&);
// How far from a side of the target its own cut may be, pixels: the vertices are those of the triangle, inverse_w the
// largest that is drawn.
double side_moved(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, double inverse_w, const Target&);

}  // namespace assay::raster
