// Luma as displayed, of a texel as two words. After halves.glsl.
READS(2, ExposureRecord, exposure);
READS(3, float, thresholds);
READS(4, uint, first_codes);
layout(binding = 5, rg8) uniform writeonly restrict image2D luma;

#define TONE_THRESHOLDS thresholds
#define TONE_FIRST_CODES first_codes
#include "harness/glsl/tone_curve.glsl"

float luma_of(uvec2 texel) {
  const vec3 exposed = colour_of(texel) * exposure[0].exposure;
  const uvec3 codes = uvec3(code_of(exposed.r), code_of(exposed.g), code_of(exposed.b));
#ifdef MUTANT_12  // red and blue swapped
  const uint sum = kLumaBlue * codes.r + kLumaGreen * codes.g + kLumaRed * codes.b;
#else
  const uint sum = kLumaRed * codes.r + kLumaGreen * codes.g + kLumaBlue * codes.b;
#endif
  return float(sum + 0x8000u >> 16) / 255.0;
}
