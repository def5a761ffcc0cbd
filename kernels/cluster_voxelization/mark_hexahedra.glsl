// Items are rasterised: which of them the bin sees, then, a thread an item and a column, the slices between the faces of
// those. Loop turns of an invocation, at 32 threads: 64 pairs of an item and a column, each with 30 half-spaces, 33
// slices that they cut off and 32 to mark; 130 for the bin's words.
#include "kernels/cluster_voxelization/hexahedra.glsl"

void mark_tile(uint item_index, uint bit, uvec2 at, uint tile) {
  if (!is_in_bounds(item_index, at, at)) return;  // nor are columns and rows that the grid has not
#ifdef HI_Z
  const ivec2 span = span_of(item_index, tile_between(at, at), depths_of(at));
#else
  const ivec2 span = span_of(item_index, tile_between(at, at), vec2(0.0, kFarthest));
#endif
  for (int slice = span.x; slice <= span.y; ++slice) mark(tile, slice, bit);
}

void main() {
  const Word word = word_of_group(gl_WorkGroupID.x);
  const uvec2 first = first_of_bin(gl_WorkGroupID.y);
  if (!is_in_grid(first) || slices() == 0u || !is_word(word)) return;  // the whole group
  clear_bin();
  list_items(word, first);
  for (uint i = gl_LocalInvocationID.x; i < listed_count * kBinTiles; i += THREADS) {
    const uint bit = listed[i / kBinTiles], tile = i % kBinTiles;
    mark_tile(item_of(word, bit), bit, tile_of_bin(first, tile), tile);
  }
#ifndef MUTANT_17  // the barrier dropped: what higher subgroups have yet to mark is missing
  barrier();
#endif
  store_bin(word, first);
}
