// A bit for each position of the tile's list at which a group begins, and a bit for each word of them that is not 0, so
// that a look back is not a search.
shared uint group_starts[kStartWords];
shared uint words_with_starts;
shared uint listed;  // pixels of the list

uint bits_below(uint n) { return (1u << n) - 1u; }  // n below 32

// The last start of a group before position word * 32; there is one, for the list has one at 0.
uint start_before(uint word) {
  const uint below = findMSB(words_with_starts & bits_below(word));
  return below << 5u | uint(findMSB(group_starts[below]));
}
// The last one at or before the position, which is in the list.
uint group_start(uint position) {
  const uint word = position >> 5u, bits = group_starts[word] & (2u << (position & 31u)) - 1u;
  return bits != 0u ? word << 5u | uint(findMSB(bits)) : start_before(word);
}
