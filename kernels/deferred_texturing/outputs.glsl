// The G-buffer's images, and a texel of each at a time.
#ifndef DEFERRED_TEXTURING_OUTPUTS
#define DEFERRED_TEXTURING_OUTPUTS
#include "harness/glsl/ports.glsl"
#include "kernels/deferred_texturing/layout.h"
#include "kernels/deferred_texturing/gbuffer_provisional.glsl"

layout(binding = 9, rgba8) uniform restrict writeonly image2D base_roughness;
layout(binding = 10, rg16_snorm) uniform restrict writeonly image2D normal;
layout(binding = 11, rg8) uniform restrict writeonly image2D metallic_occlusion;
layout(binding = 12, r32ui) uniform restrict writeonly uimage2D emissive;
WRITES(13, uint, features);

struct Texel {
  vec4 base_roughness;
  vec2 normal;
  vec2 metallic_occlusion;
  uint emissive;
  uint features;
};
void store(uvec2 pixel, Texel t) {
  const ivec2 at = ivec2(pixel);
  imageStore(base_roughness, at, t.base_roughness);
  imageStore(normal, at, vec4(t.normal, 0, 0));
  imageStore(metallic_occlusion, at, vec4(t.metallic_occlusion, 0, 0));
  imageStore(emissive, at, uvec4(t.emissive));
  features[pixel.y * params.width + pixel.x] = t.features;
}
#endif
