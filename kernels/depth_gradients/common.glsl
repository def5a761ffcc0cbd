// What every variant binds, and how a gradient is stored.
#ifndef DEPTH_GRADIENTS_COMMON
#define DEPTH_GRADIENTS_COMMON
#include "harness/glsl/half.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/depth_gradients/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 5, r32ui) uniform restrict writeonly uimage2D gradients;  // two halves
PARAMS(GradientParams);

bool on_screen(uvec2 pixel) { return pixel.x < params.width && pixel.y < params.height; }

void store_gradient(uvec2 pixel, vec2 g) {
#ifdef MUTANT_1  // what is beyond the largest half goes past its exponent
  const vec2 stored = g;
#else
  const vec2 stored = clamp(g, -kLargestGradient, kLargestGradient);
#endif
  imageStore(gradients, ivec2(pixel), uvec4(binary16(stored.x) | binary16(stored.y) << 16));
}
#endif
