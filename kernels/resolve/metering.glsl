// What a pixel adds to the sums.
#include "harness/glsl/ports.glsl"
#include "kernels/resolve/layout.h"

layout(binding = 0) uniform texture2D radiance;
PARAMS(ResolveParams);

bool is_finite(float v) { return (floatBitsToUint(v) & 0x7f800000u) != 0x7f800000u; }

PartialSum joined(PartialSum a, PartialSum b) { return PartialSum(a.sum + b.sum, a.counted + b.counted); }

PartialSum metered(uvec2 pixel) {
  const PartialSum nothing = PartialSum(0.0, 0u);
#ifdef MUTANT_1
  if (pixel.x + 1u >= params.width || pixel.y >= params.height) return nothing;
#else
  if (pixel.x >= params.width || pixel.y >= params.height) return nothing;
#endif
  const vec4 texel = texelFetch(radiance, ivec2(pixel), 0);
#ifndef MUTANT_2  // the background counts
  if (!(texel.a > 0.0)) return nothing;
#endif
#ifndef MUTANT_3  // what is no number counts
  if (!is_finite(texel.r + texel.g + texel.b)) return nothing;
#endif
  // `precise`: nothing is fused, so that the mean has the same bits on every device.
  const vec3 c = max(texel.rgb, 0.0);
  precise const float luminance = kLuminanceRed * c.r + kLuminanceGreen * c.g + kLuminanceBlue * c.b;
  if (params.metering == kMeterMean) return PartialSum(luminance, 1u);
#ifdef MUTANT_4  // the logarithm of 0
  return PartialSum(log2(luminance), 1u);
#else
  return PartialSum(log2(max(luminance, kLeastLuminance)), 1u);
#endif
}

// 8x8 pixels of a thread, 16 apart so that a subgroup's loads lie side by side: 7 sums in a row of its pixels, then 7 of
// the rows, which leaves half the error of 63 in a chain.
PartialSum metered_thread(uvec2 block, uint thread) {
  const uvec2 first = block * kBlockPixels + uvec2(thread % 16u, thread / 16u);
  PartialSum all = PartialSum(0.0, 0u);
  for (uint j = 0u; j < kThreadPixels; ++j) {
    PartialSum row = PartialSum(0.0, 0u);
    for (uint i = 0u; i < kThreadPixels; ++i) row = joined(row, metered(first + 16u * uvec2(i, j)));
    all = joined(all, row);
  }
  return all;
}
