#version 460
// A footprint 32 texels long and 4 wide, along u and along v.
#include "harness/glsl/ports.glsl"

layout(local_size_x = 2) in;
layout(binding = 0) uniform sampler2DArray textures[1];
WRITES(1, float, reds);

void main() {
  const bool is_along_u = gl_LocalInvocationIndex == 0u;
  const vec2 size = vec2(textureSize(textures[0], 0).xy), u = vec2(1, 0) / size, v = vec2(0, 1) / size;
  reds[gl_LocalInvocationIndex] =
      textureGrad(textures[0], vec3(0.5, 0.5, 0), is_along_u ? 32.0 * u : 32.0 * v, is_along_u ? 4.0 * v : 4.0 * u).r;
}
