// Vertices as the oracle knows them: exact positions, and how far a device may be from them. README.md, "Bounds".
#pragma once
#include "harness/oracle.h"
#include "kernels/visibility/layout.h"

namespace assay::visibility {

// Clip coordinates by the surface's rows, in double, and bounds of what an fp32 shader may compute for them.
struct ClipVertex {
  double x = 0, y = 0, w = 0;
  double x_error = 0, y_error = 0, w_error = 0;
  bool finite = true;
};
ClipVertex transform(const SurfaceRecord&, const vec3& position);

// What the oracle knows of the target and of the device.
struct Target {
  double width = 0, height = 0;  // pixels
  double near_plane = 0;         // metres
  double grid = 256;             // sub-pixel positions a pixel
};

// A corner in framebuffer coordinates, pixels, y down.
struct Corner {
  double x = 0, y = 0, inverse_w = 0;
  // The rasteriser's position lies within snap_x of snapped_x, likewise y: a grid point where only one is possible.
  double snapped_x = 0, snapped_y = 0, snap_x = 0, snap_y = 0;
  double moved = 0;           // how far from (x, y) it may be in either coordinate: pixels
  double relative_error = 0;  // of 1/w
};
// A vertex in front of the near plane.
Corner corner_of(const ClipVertex&, const Target&);
// Where the edge from `inside` to `behind` meets the near plane.
Corner near_corner(const ClipVertex& inside, const ClipVertex& behind, const Target&);
// Rounding of a corner that clipping against a side plane puts on the edge a-b where 1/w is inverse_w: pixels, and of
// 1/w.
struct SideError {
  double moved = 0, relative = 0;
};
SideError side_error(const ClipVertex& a, const ClipVertex& b, double inverse_w, const Target&);

}  // namespace assay::visibility
