// Colours are RGBA8 packed into a uint, red in the lowest byte. The views are in harness/formats/debug_view.h.
#ifndef DEBUG_VIEW_LAYOUT_H
#define DEBUG_VIEW_LAYOUT_H
#include "harness/formats/clusters.h"
#include "harness/formats/debug_view.h"
#include "harness/formats/features.h"
#include "harness/formats/pixel_commands.h"
#include "harness/formats/scene.h"
#include "harness/formats/shadow.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/formats/workloads.h"
#include "harness/shared.h"
SHARED_BEGIN(debug_view)

struct ViewParams {
  uint width;  // pixels
  uint height;
  uint view;         // kView...; any other shows materials
  uint surfaces;     // an index at or above it is shown as kBrokenColour
  uint materials;    // likewise
  uint workloads;    // rows of the tile workload table
  uint shaders;      // visible shader classes; a slot at or above it is shown as kBrokenColour
  ClusterGrid grid;  // of the clusters view
  // Of the shadows view: the atlas, 0 to 16384 texels, and the tiles in it.
  uint shadow_width;
  uint shadow_height;
  uint shadow_views;
};

SHARED_CONST uint kBackgroundColour = 0xff302820u;  // no surface: a dark blue grey
SHARED_CONST uint kBrokenColour = 0xffff00ffu;      // an index that names nothing: magenta
SHARED_CONST uint kRunPixels = 8u;                  // that a thread of run.comp walks
SHARED_CONST uint kHeatColours = 33u;               // for 0 to 32 features
SHARED_CONST float kLeastShownDepth = 0.00390625f;  // in the shadow atlas; less is as nothing
// The square of a tile that shows which features it has, not only how many: pixels [first, end) from the tile's corner.
SHARED_CONST uint kChipFirst = 3u;
SHARED_CONST uint kChipEnd = 9u;

#ifdef __cplusplus
SHARED_LAYOUT(ViewParams, width, height, view, surfaces, materials, workloads, shaders, grid, shadow_width,
              shadow_height, shadow_views);
#endif
SHARED_END
#endif
