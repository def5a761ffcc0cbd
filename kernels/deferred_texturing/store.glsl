// What every texturing shader writes of a pixel.
#ifndef DEFERRED_TEXTURING_STORE
#define DEFERRED_TEXTURING_STORE
#include "kernels/deferred_texturing/common.glsl"
#define GBUFFER_WRITES 9
#include "harness/glsl/gbuffer.glsl"
WRITES(13, uint, features);

void store(uvec2 pixel, GBufferTexel t, uint bits) {
  store_gbuffer(pixel, t);
  features[pixel_number(pixel)] = bits;
}
void store_nothing(uvec2 pixel) {
  store_no_surface(pixel);
  features[pixel_number(pixel)] = 0u;
}
#endif
