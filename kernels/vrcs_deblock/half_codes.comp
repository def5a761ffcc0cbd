#version 460
// The displayed code of every half at the exposure: a screen asks for more than there are halves.
// Loop turns of an invocation: at most 255, in the tone curve.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_deblock/halves.glsl"
#include "kernels/vrcs_deblock/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
READS(0, ExposureRecord, exposure);
READS(1, float, thresholds);
READS(2, uint, first_codes);
layout(binding = 3, r8ui) uniform writeonly restrict uimage2D half_codes;

#define TONE_THRESHOLDS thresholds
#define TONE_FIRST_CODES first_codes
#include "harness/glsl/tone_curve.glsl"

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
#ifdef MUTANT_20  // halves by columns
  const uint half_bits = at.x * kHalfCodesSide + at.y;
#else
  const uint half_bits = at.y * kHalfCodesSide + at.x;
#endif
  imageStore(half_codes, ivec2(at), uvec4(code_of(from_half(half_bits) * exposure[0].exposure)));
}
