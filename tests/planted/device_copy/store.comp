#version 460
#include "harness/glsl/ports.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32ui) uniform writeonly uimage2D stored;

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(at, imageSize(stored)))) imageStore(stored, at, uvec4(at.x + 1000 * at.y));
}
