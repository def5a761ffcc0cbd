// The (shader, material) that a surface has.
READS(1, SurfaceSlot, surface_slots);

// Ascending with the shader, then the material.
uint key_of(uint surface) {
  if (surface == kWrongSurface) return kUnlisted;
  const SurfaceSlot slot = surface_slots[surface];
#ifdef MUTANT_5  // a material that is not registered is taken for the last one
  if (slot.shader >= shader_slots()) return kUnlisted;
  return slot.shader << kMaterialBits | min(slot.material, min(params.materials, kMaxMaterials) - 1u);
#else
  const bool visible = slot.shader < shader_slots() && slot.material < min(params.materials, kMaxMaterials);
  return visible ? slot.shader << kMaterialBits | slot.material : kUnlisted;
#endif
}
