// The 32 items of one kind that a group works on: a word of each cell.
#include "kernels/cluster_voxelization/common.glsl"

WRITES(4, uint, light_bits);  // word after word: bit i of word w of a cell is item 32 w + i; cells by column, row, slice
WRITES(5, uint, decal_bits);
WRITES(6, uint, probe_bits);

uint words(uint count) { return (count + 31u) / 32u; }
uint cells() { return columns() * rows() * slices(); }

struct Word {
  uint kind;        // lights, decals, probes
  uint first_item;  // of the kind
  uint items;       // of the kind
  uint index;       // of the kind's words
};

Word word_of_group(uint group) {
  Word word = Word(0u, 0u, lights(), group);
  if (word.index >= words(word.items)) word = Word(1u, lights(), decals(), word.index - words(word.items));
  if (word.kind == 1u && word.index >= words(word.items))
    word = Word(2u, lights() + decals(), probes(), word.index - words(word.items));
  return word;
}
bool is_word(Word word) { return word.index < words(word.items); }

uint item_of(Word word, uint bit) { return word.first_item + word.index * 32u + bit; }
bool has_item(Word word, uint bit) {
#ifdef MUTANT_8  // the last word's other bits are other kinds' items
  return item_of(word, bit) < lights() + decals() + probes();
#else
  return word.index * 32u + bit < word.items;
#endif
}

void store_bits(Word word, uint cell, uint bits) {
  const uint to = word.index * cells() + cell;
  if (word.kind == 0u) light_bits[to] = bits;
  if (word.kind == 1u) decal_bits[to] = bits;
  if (word.kind == 2u) probe_bits[to] = bits;
}
