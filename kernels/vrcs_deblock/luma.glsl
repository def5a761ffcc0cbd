// What the next frame's rates are made of.
layout(binding = 4) uniform utexture2D half_codes;
layout(binding = 5, rg8) uniform writeonly restrict image2D luma;
#include "harness/glsl/luma.glsl"

void store_luma(ivec2 pixel, uvec2 texel) { imageStore(luma, pixel, vec4(float(luma_code(texel)) / 255.0)); }
