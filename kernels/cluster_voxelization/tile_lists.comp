#version 460
// Two lists of the same items: of each column, all that reach the depths of its surfaces, at whatever slice; and of each
// bin and slice. A word of either has one owner; how long they are is counted over all words of a kind.
// Loop turns of an invocation, at 32 threads: 64 pairs of an item and a column, then 1 of an item and the bin, each with 30
// half-spaces and 33 slices that they cut off.
#define HI_Z
#include "kernels/cluster_voxelization/hexahedra.glsl"
#include "kernels/cluster_voxelization/lists.glsl"

WRITES(10, uint, list_bits);
UPDATES(11, uint, list_lengths);

void store_list(Word word, uint list, uint bits) {
  list_bits[gl_WorkGroupID.x * lists() + list] = bits;
#ifdef MUTANT_26  // the length of the last word to come
  if (bits != 0u) list_lengths[word.kind * lists() + list] = bitCount(bits);
#else
  if (bits != 0u) atomicAdd(list_lengths[word.kind * lists() + list], bitCount(bits));
#endif
}

void main() {
  const Word word = word_of_group(gl_WorkGroupID.x);
  const uvec2 first = first_of_bin(gl_WorkGroupID.y);
  const uint thread = gl_LocalInvocationID.x;
  if (!is_in_grid(first) || slices() == 0u || !is_word(word)) return;  // the whole group
  // Columns first, then slices.
  for (uint i = thread; i < kBinTiles + slices(); i += THREADS) cell_bits[i] = 0u;
  list_items(word, first);
  for (uint i = thread; i < listed_count * kBinTiles; i += THREADS) {
    const uint bit = listed[i / kBinTiles], tile = i % kBinTiles, item_index = item_of(word, bit);
    const uvec2 at = tile_of_bin(first, tile);
    if (is_in_bounds(item_index, at, at) && !is_empty(span_of(item_index, tile_between(at, at), depths_of(at))))
      atomicOr(cell_bits[tile], 1u << bit);
  }
  for (uint i = thread; i < listed_count; i += THREADS) {
    const ivec2 span =
        span_of(item_of(word, listed[i]), tile_between(first, last_of_bin(first)), vec2(0.0, kFarthest));
    for (int slice = span.x; slice <= span.y; ++slice) atomicOr(cell_bits[kBinTiles + uint(slice)], 1u << listed[i]);
  }
#ifndef MUTANT_27  // the barrier dropped: what higher subgroups have yet to mark is missing
  barrier();
#endif
  for (uint i = thread; i < kBinTiles; i += THREADS) {
    const uvec2 at = tile_of_bin(first, i);
    if (is_in_grid(at)) store_list(word, list_of_column(at), cell_bits[i]);
  }
  for (uint i = thread; i < slices(); i += THREADS)
    store_list(word, list_of_bin(first / kBinSide, i), cell_bits[kBinTiles + i]);
}
