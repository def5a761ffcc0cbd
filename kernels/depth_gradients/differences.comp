#version 460
// From the depths of the neighbours: the lesser of the steps forward and back, so that an edge on one side does no harm.
#include "kernels/depth_gradients/common.glsl"

layout(binding = 4) uniform texture2D depth;

// Of a surface on the screen, else 0; integers compare NaN too.
float depth_at(ivec2 pixel) {
  if (!on_screen(uvec2(pixel))) return 0.0;
  const float d = texelFetch(depth, pixel, 0).r;
  const uint bits = floatBitsToUint(d);
  return bits >= floatBitsToUint(kLeastDepth) && bits < 0x7f800000u ? d : 0.0;
}

float lesser_step(ivec2 pixel, ivec2 along, float here) {
  const float before = depth_at(pixel - along), after = depth_at(pixel + along);
  const float back = here - before, forward = after - here;
  if (before == 0.0) return after == 0.0 ? 0.0 : forward;
  return after == 0.0 || abs(back) < abs(forward) ? back : forward;
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  const float here = depth_at(ivec2(pixel));
  if (here == 0.0) {
    store_gradient(pixel, vec2(0.0));
    return;
  }
  store_gradient(pixel,
                 vec2(lesser_step(ivec2(pixel), ivec2(1, 0), here), lesser_step(ivec2(pixel), ivec2(0, 1), here)) / here);
}
