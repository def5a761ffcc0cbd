// Parameters of the visit of pixel-command lists.
#ifndef COMMAND_VISIT_LAYOUT_H
#define COMMAND_VISIT_LAYOUT_H
#include "harness/formats/pixel_commands.h"
#include "harness/formats/scene.h"
#include "harness/shared.h"
SHARED_BEGIN(command_visit)

SHARED_CONST uint kVisitors =
    2u;  // shader slots, each with a shader of its own; each counts a pixel's visits in 8 bits

struct VisitParams {
  uint width;  // pixels
  uint height;
  uint shaders;  // visible ones; those above kVisitors are not run
  uint waves;    // that the lists hold
};

// Of a visitor: row in bits 0..7, copy bits from 8, slot from 16, what the row promises of a wave from 24. Of several
// the largest is kept.
SHARED_CONST uint kVisited = 0x80000000u;

#ifdef __cplusplus
SHARED_LAYOUT(VisitParams, width, height, shaders, waves);
#endif
SHARED_END
#endif
