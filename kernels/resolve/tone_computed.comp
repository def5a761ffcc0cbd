#version 460
// The same curve computed: Narkowicz's fit (2015), then sRGB (IEC 61966-2-1). Its powers are rounded by as much as Vulkan
// lets them be, so a pixel near the border of two codes may get either.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform texture2D radiance;
READS(1, ExposureRecord, exposure);
WRITES(3, uint, image);
PARAMS(ResolveParams);

uint code_of(float exposed) {
  if (!(exposed > 0.0)) return 0u;
  const float x = min(exposed, 1e6);  // the curve's limit, before its squares overflow
  const float linear = min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
  const float encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
  return uint(encoded * 255.0 + 0.5);
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (pixel.x >= params.width || pixel.y >= params.height) return;
  const vec3 exposed = texelFetch(radiance, ivec2(pixel), 0).rgb * exposure[0].exposure;
  image[pixel.y * params.width + pixel.x] =
      0xff000000u | code_of(exposed.b) << 16 | code_of(exposed.g) << 8 | code_of(exposed.r);
}
