// Luma of displayed codes, for the next frame's shading rates (formats/vrcs.h).
#ifndef FORMATS_LUMA_H
#define FORMATS_LUMA_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// A table of the displayed code of every half, in rows of so many.
SHARED_CONST uint kHalfCodesSide = 256u;

// Luma of displayed codes: the weights of Rec. 709 in 2^16ths, which add up to 2^16.
SHARED_CONST uint kLumaRed = 13933u;
SHARED_CONST uint kLumaGreen = 46871u;
SHARED_CONST uint kLumaBlue = 4732u;

SHARED_END
#endif
