// Luma of a texel as displayed, by the table of half_codes.comp.
layout(binding = 4) uniform utexture2D half_codes;
layout(binding = 5, rg8) uniform writeonly restrict image2D luma;

uint code_of_half(uint half_bits) { return texelFetch(half_codes, ivec2(half_bits & 255u, half_bits >> 8), 0).r; }

void store_luma(ivec2 pixel, uvec2 texel) {
  const uint red = code_of_half(texel.x & 0xffffu), green = code_of_half(texel.x >> 16),
             blue = code_of_half(texel.y & 0xffffu);
#ifdef MUTANT_12  // red and blue swapped
  const uint sum = kLumaBlue * red + kLumaGreen * green + kLumaRed * blue;
#else
  const uint sum = kLumaRed * red + kLumaGreen * green + kLumaBlue * blue;
#endif
  imageStore(luma, pixel, vec4(float(sum + 0x8000u >> 16) / 255.0));
}
