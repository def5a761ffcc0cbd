// The sum of a group's 256 values as a tree: neighbours, then neighbours of pairs, ... The same pairs whoever adds them, so
// the same bits at every subgroup width. Include after joined() is there.
shared PartialSum tree[256];

// The sum in every thread's hand that calls it with thread 0; all threads call it.
PartialSum tree_sum(PartialSum mine, uint thread) {
  tree[thread] = mine;
  barrier();
#ifdef MUTANT_5  // the last step is left out
  for (uint stride = 1u; stride < 128u; stride *= 2u) {
#else
  for (uint stride = 1u; stride < 256u; stride *= 2u) {
#endif
    if (thread % (2u * stride) == 0u) tree[thread] = joined(tree[thread], tree[thread + stride]);
    barrier();
  }
  return tree[0];
}
