// Luma of a texel of halves as displayed, by vrcs_deblock's table of codes. Before including, a shader declares `half_codes`,
// a utexture2D.
#ifndef HARNESS_GLSL_LUMA
#define HARNESS_GLSL_LUMA
#include "harness/formats/luma.h"

uint code_of_half(uint half_bits) { return texelFetch(half_codes, ivec2(half_bits & 255u, half_bits >> 8), 0).r; }

// 0 to 255 of the texel's two words.
uint luma_code(uvec2 texel) {
  const uint red = code_of_half(texel.x & 0xffffu), green = code_of_half(texel.x >> 16),
             blue = code_of_half(texel.y & 0xffffu);
#ifdef MUTANT_9731  // red and blue swapped
  const uint sum = kLumaBlue * red + kLumaGreen * green + kLumaRed * blue;
#else
  const uint sum = kLumaRed * red + kLumaGreen * green + kLumaBlue * blue;
#endif
  return sum + 0x8000u >> 16;
}
#endif
