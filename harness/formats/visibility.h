// The visibility buffer (Lazarek, Hammer 2025): 64 bits a pixel, R32G32_UINT.
// x = triangle index within its mesh, before culling.
// y = surface (instance) index in bits 0..29, bit 30 hardware-instanced, bit 31 winding flipped.
// No surface: both all ones.
#ifndef FORMATS_VISIBILITY_H
#define FORMATS_VISIBILITY_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kVisibilityNone = 0xffffffffu;
SHARED_CONST uint kVisibilitySurfaceMask = 0x3fffffffu;
SHARED_CONST uint kVisibilityInstanced = 0x40000000u;
SHARED_CONST uint kVisibilityFlipped = 0x80000000u;

SHARED_END
#endif
