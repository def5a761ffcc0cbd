// Parameters of the coordinates of variable-rate compute shading; what comes out is in harness/formats/vrcs.h.
#ifndef VRCS_COORDINATES_LAYOUT_H
#define VRCS_COORDINATES_LAYOUT_H
#include "harness/formats/pixel_commands.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(vrcs_coordinates)

SHARED_CONST uint kBlockSide = 8u;  // a normal is rebuilt from the pixels of one such block

struct VrcsParams {
  uint width;  // pixels, 1 to 16,384
  uint height;
  uint frame;         // which pixel of a group is shaded rotates with it
  uint all_1x1;       // not 0: the rates are not looked at; the first frame, a cut, another resolution
  float fog_depth;    // reversed; a covered pixel of a smaller depth is fogged. No positive normal number: no fog
  float near_plane;   // of depth_entries, metres, above 0
  float depth_scale;  // of depth_entries: codes a metre beyond the near plane
  // Normals are close where the squared sine of their angle is at most 2^-n, and it is below 90 degrees; n is held to
  // 0..31.
  uint close_normals_log2;
  uint close_depths_log2;  // depths are close where they differ by at most 2^-n of the greater; n is held to 0..23
  uint focal_x;  // of rebuilt_normal: pixels that a view plane at distance 1 is wide a metre; held to 1..16,383
  uint focal_y;
};

#ifdef __cplusplus
SHARED_LAYOUT(VrcsParams, width, height, frame, all_1x1, fog_depth, near_plane, depth_scale, close_normals_log2,
              close_depths_log2, focal_x, focal_y);
#endif
SHARED_END
#endif
