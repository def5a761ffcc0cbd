// What attribute interpolation leaves of each pixel (Lazarek, Hammer 2025): three buffers, 4, 8 and 8 bytes a pixel,
// the element of pixel x, y at y * width + x. A pixel without a surface has all bits zero in the three. Decoded by
// harness/glsl/attributes.glsl.
//
// Weights: lambda_0 = 1 - lambda_1 - lambda_2; derivatives are of lambda_1 and lambda_2, a pixel, along x and y.
//
// packed (the frame's)
//   barycentrics   lambda_1 unorm16 in bits 0..15, lambda_2 in 16..31
//   derivatives    four 13-bit two's complement mantissas under one exponent, each standing for m * 2^(E - 139):
//                  .x: d lambda_1/dx bits 0..12, d lambda_2/dx 13..25, E bits 0..5 in 26..31
//                  .y: d lambda_1/dy bits 0..12, d lambda_2/dy 13..25, E bits 6..7 in 26..27, flags in 28..31
//                  E is 0 where the largest is under 2^-100, and all are then 0
//   tangent_frame  Lambert azimuthal x, y as snorm16: .x the normal (x low), .y the tangent; z's sign is a flag
// half_scaled: as packed, but
//   derivatives    binary16 of 64 d, rounded to 9 bits of mantissa, a flag as the lowest bit, within +-1023:
//                  .x: d lambda_1/dx low, d lambda_2/dx high; .y: d/dy
// halves (the source's)
//   barycentrics   binary16 lambda_1, lambda_2
//   derivatives    binary16 within ]-2, 2[, whose bit 14 is always 0: a flag lies there
//   tangent_frame  binary16 x, y of the normal (.x) and of the tangent (.y)
// Where the flags lie one a number, they are those of bits 28, 29, 30, 31 of `packed`, in the order of the numbers.
#ifndef FORMATS_ATTRIBUTES_H
#define FORMATS_ATTRIBUTES_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

SHARED_CONST uint kAttributesPacked = 0u;
SHARED_CONST uint kAttributesHalfScaled = 1u;
SHARED_CONST uint kAttributesHalves = 2u;
SHARED_CONST uint kAttributeLayouts = 3u;

// Flags, as bits of a number of four bits.
SHARED_CONST uint kAttributeFrontFacing = 1u;      // the side from which the triangle is counter-clockwise is seen
SHARED_CONST uint kAttributeNormalNegative = 2u;   // z of the world normal
SHARED_CONST uint kAttributeTangentNegative = 4u;  // z of the world tangent
SHARED_CONST uint kAttributeLeftHanded = 8u;       // bitangent = -cross(normal, tangent)
SHARED_CONST int kAttributeExponentBias = 139;     // of the shared exponent: a mantissa's unit is 2^(E - bias)
SHARED_CONST int kAttributeMantissaLimit = 4095;   // of a shared exponent's mantissa, either sign
SHARED_CONST float kAttributeHalfScale = 64.0f;    // half_scaled holds this many times the derivative

SHARED_END
#endif
