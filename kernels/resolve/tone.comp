#version 460
// Radiance to 8-bit codes. A code is how many of 255 ascending thresholds the exposed radiance reaches: the curve and the
// encoding are data, every monotone curve costs the same, and nothing is rounded but the one product.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform texture2D radiance;
READS(1, ExposureRecord, exposure);
READS(2, float, thresholds);  // [k] is the least exposed radiance of code k; [0] is not read
WRITES(3, uint, image);
PARAMS(ResolveParams);

shared float reached_at[kCodes];

// NaN reaches nothing and becomes 0, as does what is negative.
uint code_of(float exposed) {
  uint code = 0u;
  for (uint step_ = 128u; step_ != 0u; step_ /= 2u)
#ifdef MUTANT_11  // > for >=
    if (exposed > reached_at[code + step_]) code += step_;
#else
    if (exposed >= reached_at[code + step_]) code += step_;
#endif
  return code;
}

void main() {
#ifdef MUTANT_12  // neighbours in the table swapped
  reached_at[gl_LocalInvocationIndex ^ 1u] = thresholds[gl_LocalInvocationIndex];
#else
  reached_at[gl_LocalInvocationIndex] = thresholds[gl_LocalInvocationIndex];
#endif
  barrier();
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const vec3 exposed = texelFetch(radiance, ivec2(pixel), 0).rgb * exposure[0].exposure;
#ifdef MUTANT_13  // blue lowest
  const uvec3 c = uvec3(code_of(exposed.b), code_of(exposed.g), code_of(exposed.r));
#else
  const uvec3 c = uvec3(code_of(exposed.r), code_of(exposed.g), code_of(exposed.b));
#endif
  image[pixel.y * params.width + pixel.x] = 0xff000000u | c.b << 16 | c.g << 8 | c.r;
}
