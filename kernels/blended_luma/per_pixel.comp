// Green becomes the luma of the picture as it is now; red stays that of the opaque surfaces.
#include "harness/glsl/ports.glsl"
#include "kernels/blended_luma/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0, rg32ui) uniform readonly restrict uimage2D radiance;
layout(binding = 1) uniform utexture2D half_codes;
layout(binding = 2, rg8) uniform restrict image2D luma;
PARAMS(LumaParams);
#include "harness/glsl/luma.glsl"

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef MUTANT_1  // the last column is left out
  if (pixel.x + 1 >= int(params.width) || pixel.y >= int(params.height)) return;
#else
  if (pixel.x >= int(params.width) || pixel.y >= int(params.height)) return;
#endif
#ifdef MUTANT_2  // of the transposed pixel
  const uvec2 texel = imageLoad(radiance, pixel.yx).xy;
#else
  const uvec2 texel = imageLoad(radiance, pixel).xy;
#endif
  vec2 codes = imageLoad(luma, pixel).xy;
#ifdef MUTANT_3  // red is the blended luma, green the opaque one
  codes = vec2(float(luma_code(texel)) / 255.0, codes.x);
#elif defined(MUTANT_4)  // both are the blended luma
  codes = vec2(float(luma_code(texel)) / 255.0);
#elif defined(MUTANT_5)  // red and green of the picture swapped
  codes.y = float(luma_code(uvec2(texel.x << 16 | texel.x >> 16, texel.y))) / 255.0;
#elif defined(MUTANT_6)  // blue of the alpha
  codes.y = float(luma_code(uvec2(texel.x, texel.y >> 16))) / 255.0;
#else
  codes.y = float(luma_code(texel)) / 255.0;
#endif
  imageStore(luma, pixel, vec4(codes, 0.0, 0.0));
}
