// The surface of a pixel, and the (shader, material) that it has.
layout(binding = 0) uniform utexture2D visibility;
READS(1, SurfaceSlot, surface_slots);
layout(binding = 2) uniform utexture2D copy_bits;

uint copy_bits_of(uvec2 pixel) { return params.copies != 0u ? texelFetch(copy_bits, ivec2(pixel), 0).x : 0u; }

uint surface_of_pixel(uvec2 pixel) {
  if (!on_screen(pixel, extent())) return kNoSurface;
  if ((copy_bits_of(pixel) & kCopyDuplicate) != 0u) return kNoSurface;
  const uvec2 seen = texelFetch(visibility, ivec2(pixel), 0).xy;
#ifdef MUTANT_2  // the last surface index is taken for none at all, whatever the triangle
  if ((seen.y & kVisibilitySurfaceMask) == kVisibilitySurfaceMask) return kNoSurface;
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

const uint kMaterialBits = 12u;  // kMaxMaterials
uint shader_of(uint key) { return key >> kMaterialBits; }
uint material_of(uint key) { return key & (kMaxMaterials - 1u); }

// Ascending with the shader, then the material.
uint key_of(uint surface) {
  if (surface == kWrongSurface) return kUnlisted;
  const SurfaceSlot slot = surface_slots[surface];
#ifdef MUTANT_5  // a material that is not registered is taken for the last one
  if (slot.shader >= shader_slots()) return kUnlisted;
  return slot.shader << kMaterialBits | min(slot.material, min(params.materials, kMaxMaterials) - 1u);
#else
  const bool listed = slot.shader < shader_slots() && slot.material < min(params.materials, kMaxMaterials);
  return listed ? slot.shader << kMaterialBits | slot.material : kUnlisted;
#endif
}

uint entry_of(uvec2 pixel) {
  return pixel.x | pixel.y << kEntryCoordinateBits | (copy_bits_of(pixel) & kCopyBits) << kEntryCopyShift;
}
