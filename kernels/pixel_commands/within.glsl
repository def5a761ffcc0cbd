// A surface's first pixel among those of its group: surfaces in the order of the list.
uint place_in_group(uint i) {
#ifdef MUTANT_9  // its own pixels count
  return (group_at[i] & kTilePixels - 1u) + pixels_at[used_slots[i]];
#else
  return group_at[i] & kTilePixels - 1u;
#endif
}
