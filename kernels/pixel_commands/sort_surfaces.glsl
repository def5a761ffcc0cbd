// The words of used_slots in ascending order. A few: each thread counts those below its own. More: a bitonic network in
// which every exchange is ascending (its first step of a stage compares mirrored), so that what is past the end need
// not be filled in. No word is there twice.
// Loop turns of an invocation: the threads; or 55 steps of 512 exchanges over the threads, 880 at 32 threads.
void sort_by_counting(uint thread, uint n) {
  const uint word = thread < n ? used_slots[thread] : 0u;
  uint below = 0u;
  if (thread < n)
    for (uint j = 0u; j < n; ++j) below += uint(used_slots[j] < word);
#ifndef MUTANT_36  // the barrier dropped: words are written over before higher subgroups have counted them
  barrier();
#endif
  if (thread < n) used_slots[below] = word;
  barrier();
}

void sort_by_exchanges(uint thread, uint n) {
  const uint size = 2u << findMSB(n - 1u);
  for (uint stage = 2u; stage <= size; stage *= 2u)
    for (uint reach = stage / 2u; reach > 0u; reach /= 2u) {
      for (uint i = thread; i < size / 2u; i += THREADS) {
        const uint low = i / reach * reach * 2u + i % reach;
#ifdef MUTANT_37  // no step is mirrored: halves that both ascend are not merged
        const uint high = low + reach;
#else
        const uint high = reach == stage / 2u ? low ^ stage - 1u : low + reach;
#endif
        if (high >= n || used_slots[low] < used_slots[high]) continue;
        const uint word = used_slots[low];
        used_slots[low] = used_slots[high];
        used_slots[high] = word;
      }
      barrier();
    }
}

void sort_surfaces(uint thread, uint n) {
  if (n <= THREADS)  // the whole group
    sort_by_counting(thread, n);
  else
    sort_by_exchanges(thread, n);
}
