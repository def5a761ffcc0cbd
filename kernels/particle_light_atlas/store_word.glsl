// A word a texel, as ENCODING says.
layout(binding = 5, r32ui) uniform writeonly restrict uimage2D atlas;

void store_radiance(uvec2 at, vec3 radiance) {
  imageStore(atlas, ivec2(at), uvec4(encode_radiance(radiance, ENCODING), 0u, 0u, 0u));
}
