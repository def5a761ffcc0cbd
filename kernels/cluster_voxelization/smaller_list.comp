#version 460
// A thread a word and a cell: the shorter of the list of its column and that of its bin and slice; the column's where
// they are as long.
#include "kernels/cluster_voxelization/word.glsl"
#include "kernels/cluster_voxelization/lists.glsl"

layout(local_size_x = 64) in;
READS(2, uint, list_bits);
READS(3, uint, list_lengths);

void main() {
  const Word word = word_of_group(gl_WorkGroupID.y);
  const uint cell = gl_GlobalInvocationID.x;
  if (!is_word(word) || cell >= cells()) return;
  const uvec2 at = uvec2(cell % columns(), cell / columns() % rows());
  const uint slice = cell / (columns() * rows());
#ifdef MUTANT_28  // the slice before
  const uint of_column = list_of_column(at), of_bin = list_of_bin(at / kBinSide, max(slice, 1u) - 1u);
#else
  const uint of_column = list_of_column(at), of_bin = list_of_bin(at / kBinSide, slice);
#endif
  const uint lengths = word.kind * lists();
#ifdef MUTANT_29  // the longer
  const bool is_columns = list_lengths[lengths + of_column] > list_lengths[lengths + of_bin];
#else
  const bool is_columns = list_lengths[lengths + of_column] <= list_lengths[lengths + of_bin];
#endif
  store_bits(word, cell, list_bits[gl_WorkGroupID.y * lists() + (is_columns ? of_column : of_bin)]);
}
