// Where the lists of columns lie, and those of bins and slices.
#ifdef MUTANT_30  // of whole columns alone
uvec2 bins() { return max(uvec2(columns(), rows()) / kBinSide, 1u); }
#else
uvec2 bins() { return (uvec2(columns(), rows()) + kBinSide - 1u) / kBinSide; }
#endif
uint lists() { return columns() * rows() + bins().x * bins().y * slices(); }
uint list_of_column(uvec2 at) { return at.y * columns() + at.x; }
uint list_of_bin(uvec2 bin, uint slice) {
  return columns() * rows() + (slice * bins().y + bin.y) * bins().x + bin.x;
}
