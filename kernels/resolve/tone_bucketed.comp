#version 460
// As tone.comp, with two loads a channel for the eight of its search.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform texture2D radiance;
READS(1, ExposureRecord, exposure);
READS(2, float, thresholds);
WRITES(3, uint, image);
READS(4, uint, first_codes);
PARAMS(ResolveParams);

#define TONE_THRESHOLDS thresholds
#define TONE_FIRST_CODES first_codes
#include "harness/glsl/tone_curve.glsl"

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const vec3 exposed = texelFetch(radiance, ivec2(pixel), 0).rgb * exposure[0].exposure;
  image[pixel.y * params.width + pixel.x] =
      0xff000000u | code_of(exposed.b) << 16 | code_of(exposed.g) << 8 | code_of(exposed.r);
}
