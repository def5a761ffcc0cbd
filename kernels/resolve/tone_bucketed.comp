#version 460
// As tone.comp, without its search: the leading bits of the exposed radiance name a bucket, a table says the code at the
// bucket's start, and the thresholds from there on are compared with, mostly one. Two loads a channel for eight.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform texture2D radiance;
READS(1, ExposureRecord, exposure);
READS(2, float, thresholds);
WRITES(3, uint, image);
READS(4, uint, first_codes);
PARAMS(ResolveParams);

// At most 255 turns, for any ascending table.
uint code_of(float exposed) {
  if (!(exposed > 0.0)) return 0u;
  const uint leading = floatBitsToUint(exposed) >> kBucketShift;
  if (leading < kFirstBucket) return 0u;
#ifdef MUTANT_15  // what is past the last bucket is black
  if (leading >= kFirstBucket + kBuckets) return 0u;
#else
  if (leading >= kFirstBucket + kBuckets) return kCodes - 1u;
#endif
  uint code = first_codes[leading - kFirstBucket];
#ifndef MUTANT_14  // a bucket's first code for all of it
  while (code + 1u < kCodes && exposed >= thresholds[code + 1u]) ++code;
#endif
  return code;
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const vec3 exposed = texelFetch(radiance, ivec2(pixel), 0).rgb * exposure[0].exposure;
  image[pixel.y * params.width + pixel.x] =
      0xff000000u | code_of(exposed.b) << 16 | code_of(exposed.g) << 8 | code_of(exposed.r);
}
