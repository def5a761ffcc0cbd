// Radiance is read from one image and stored in another: no thread reads what another writes.
#include "kernels/vrcs_deblock/deblock.glsl"

layout(binding = 6, rg32ui) uniform readonly restrict uimage2D radiance;
layout(binding = 7, rg32ui) uniform writeonly restrict uimage2D deblocked_radiance;

uvec2 texel_at(ivec2 pixel) { return imageLoad(radiance, pixel).rg; }
void store_texel(ivec2 pixel, uvec2 texel, bool changed) {
  imageStore(deblocked_radiance, pixel, uvec4(texel, 0u, 0u));
}
