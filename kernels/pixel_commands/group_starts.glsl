// A bit for each position of the tile's list at which a group begins.
shared uint group_starts[kStartWords];
shared uint listed;  // pixels of the list

// The last start of a group at or before the position, which is in the list.
uint group_start(uint position) {
  uint word = position >> 5u;
  uint bits = group_starts[word] & (2u << (position & 31u)) - 1u;
  while (bits == 0u && word > 0u) bits = group_starts[--word];
  return word << 5u | uint(findMSB(bits));
}
// The first one after it, the end of the list where there is none.
uint group_end(uint position) {
  uint word = position >> 5u;
  uint bits = group_starts[word] & ~((2u << (position & 31u)) - 1u);
  while (bits == 0u && ++word < kStartWords) bits = group_starts[word];
  return bits == 0u ? listed : word << 5u | uint(findLSB(bits));
}
