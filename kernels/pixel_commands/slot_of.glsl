// The surface's slot, taken if it has none.
uint slot_of(uint surface) {
  uint slot = surface * 2654435769u >> 32u - kSlotBits;  // Knuth's multiplicative hash
  for (uint probe = 0u; probe < kTilePixels; ++probe) {
    uint there = surface_at[slot];
    if (there == kFree) {
      there = atomicCompSwap(surface_at[slot], kFree, surface);
      if (there == kFree) used_slots[atomicAdd(used, 1u)] = slot;
    }
#ifdef MUTANT_6  // whoever has the slot
    break;
#else
    if (there == kFree || there == surface) break;
#endif
    slot = slot + 1u & kTilePixels - 1u;
  }
  return slot;
}
