// A word a texel of ATLAS, as ENCODING says.
#ifndef ATLAS
#define ATLAS atlas
#endif
layout(binding = 5, r32ui) uniform writeonly restrict uimage2D ATLAS;

void store_radiance(uvec2 at, vec3 radiance) {
  imageStore(ATLAS, ivec2(at), uvec4(encode_radiance(radiance, ENCODING), 0u, 0u, 0u));
}
