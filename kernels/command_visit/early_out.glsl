// Lazarek and Hammer's two permutations, EARLY_OUT the kind of this one: all waves are dispatched for both, and each
// runs in the one that it is made for. What is uniform is found by subgroup, whatever the lists say.
bool to_run(uint surface) {
#ifdef MUTANT_1  // one lane speaks for all
  const bool alike = true;
#else
  const bool alike = subgroupBallot(surface != subgroupBroadcastFirst(surface)) == uvec4(0u);
#endif
#ifdef MUTANT_2  // the divergent permutation runs every subgroup
  return EARLY_OUT == kDivergentLists || alike;
#else
  return alike == (EARLY_OUT == kUniformLists);
#endif
}
bool is_uniform() { return EARLY_OUT == kUniformLists; }
