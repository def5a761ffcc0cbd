#version 460
// Each texel of a level, fetched and sampled at its centre.
#include "harness/glsl/ports.glsl"
#include "tests/planted/device_texels/layout.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2DArray textures[1];
WRITES(1, vec4, fetched);
WRITES(2, vec4, sampled);
PARAMS(TexelParams);

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (at.x >= params.width || at.y >= params.height) return;
  const uint i = at.y * params.width + at.x;
  const vec2 centre = (vec2(at) + 0.5) / vec2(params.width, params.height);
  fetched[i] = texelFetch(textures[0], ivec3(at, params.layer), int(params.level));
  sampled[i] = textureLod(textures[0], vec3(centre, params.layer), float(params.level));
}
