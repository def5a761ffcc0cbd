#version 460
#include "harness/glsl/ports.glsl"

layout(local_size_x = 256) in;
READS(0, vec2, places);
layout(binding = 1) uniform sampler2DArray textures[2];  // sRGB, linear
WRITES(2, float, alphas);
WRITES(3, vec4, texels);

// As many places as threads: the kernel's extent is a multiple of the group.
void main() {
  const uint i = gl_GlobalInvocationID.x;
  const vec3 place = vec3(places[i], 0);
  alphas[i] = textureLod(textures[0], place, 0).a;
  texels[i] = textureLod(textures[1], place, 0);
}
