// Parameters of the visit of variable-rate compute shading's lists.
#ifndef VRCS_REMAP_LAYOUT_H
#define VRCS_REMAP_LAYOUT_H
#include "harness/formats/pixel_commands.h"
#include "harness/formats/scene.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/shared.h"
SHARED_BEGIN(vrcs_remap)

struct RemapParams {
  uint width;  // pixels, 1 to 16,384
  uint height;
  uint frame;    // that the lists were made with
  uint hostile;  // not 0: the lists are nobody's; 0: they are of this screen, and the oracle goes by what is covered
};

#ifdef __cplusplus
SHARED_LAYOUT(RemapParams, width, height, frame, hostile);
#endif
SHARED_END
#endif
