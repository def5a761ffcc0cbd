// After match_runs.glsl: the pixels of a group in scan order, whichever thread was faster. The tile's runs stand in scan
// order in shared memory, for which the table is no longer needed, and a run looks back at those of its group.
// Loop turns of an invocation: the threads, and 1024 for each of its runs; at 256 threads 4096.
#define RUN_FIRST surface_at   // the first entry of the run's group
#define RUN_LENGTH pixels_at

shared uint runs_of[THREADS];

uint run_length(uint rest) {  // of the first run in `rest`
  const uint later = rest & rest - 1u;
  return (later != 0u ? findLSB(later) : kPixelsPerThread) - findLSB(rest);
}

void write_pixels(uint tile) {
  const uint thread = gl_LocalInvocationID.x;
  runs_of[thread] = bitCount(run_starts);
  barrier();
  uint first_run = 0u;
  for (uint t = 0u; t < thread; ++t) first_run += runs_of[t];
  uint k = first_run;
  for (uint rest = run_starts; rest != 0u; rest &= rest - 1u) {
    const uint place = run_place[k - first_run];
    RUN_FIRST[k] = place == kFree ? kNowhere : place_at[place >> kSlotBits];
    RUN_LENGTH[k] = run_length(rest);
    ++k;
  }
  barrier();
  k = first_run;
  for (uint rest = run_starts; rest != 0u; rest &= rest - 1u) {
    uint entry = RUN_FIRST[k];
    if (entry != kNowhere) {
#ifdef MUTANT_26  // a run looks at its neighbours alone
      for (uint j = first_run; j < k; ++j)
#else
      for (uint j = 0u; j < k; ++j)
#endif
        if (RUN_FIRST[j] == RUN_FIRST[k]) entry += RUN_LENGTH[j];
      for (uint i = 0u; i < run_length(rest); ++i) entries[entry + i] = entry_of(pixel_of_thread(findLSB(rest) + i));
    }
    ++k;
  }
}
