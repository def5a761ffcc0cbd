// The surface of a pixel, and where it is copied to.
layout(binding = 0) uniform utexture2D visibility;
#ifdef COPY_BITS  // passes of their own: only they bind the image, and only they run where there is one
layout(binding = 2) uniform utexture2D copy_bits;
uint copy_bits_of(uvec2 pixel) { return texelFetch(copy_bits, ivec2(pixel), 0).x; }
#else
uint copy_bits_of(uvec2 pixel) { return 0u; }
#endif

bool is_duplicate(uvec2 pixel) { return on_screen(pixel, extent()) && (copy_bits_of(pixel) & kCopyDuplicate) != 0u; }

uint surface_of_pixel(uvec2 pixel) {
  if (!on_screen(pixel, extent()) || is_duplicate(pixel)) return kNoSurface;
  const uvec2 seen = texelFetch(visibility, ivec2(pixel), 0).xy;
#ifdef MUTANT_2  // a triangle of all ones is taken for nothing
  if (seen.x == kVisibilityNone) return kNoSurface;
#else
  if (seen == uvec2(kVisibilityNone)) return kNoSurface;
#endif
#ifdef MUTANT_3  // the flags stay in the index
  const uint surface = seen.y;
#else
  const uint surface = seen.y & kVisibilitySurfaceMask;
#endif
#ifdef MUTANT_4  // the last surface is out of range
  return surface + 1u < params.surfaces ? surface : kWrongSurface;
#else
  return surface < params.surfaces ? surface : kWrongSurface;
#endif
}

uint copies_of_pixel(uvec2 pixel) { return copy_bits_of(pixel) & kCopyBits; }
