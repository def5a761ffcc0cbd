// Four halves a texel.
layout(binding = 5, rg32ui) uniform writeonly restrict uimage2D atlas_rgba16;

void store_radiance(uvec2 at, vec3 radiance) {
  imageStore(atlas_rgba16, ivec2(at), uvec4(encode_rgba16(radiance), 0u, 0u));
}
