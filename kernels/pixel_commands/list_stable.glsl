// After match_runs.glsl and group_surfaces(): the pixels of a group in scan order, whichever thread was faster. The
// tile's runs stand in scan order in shared memory, and a run looks back at those of its group. By then the surfaces are
// no longer needed; the table of pixels is read into run_place before runs are put in its stead.
// Loop turns of an invocation: the threads, and 1024 for each of its runs; at 256 threads 4096.
#define RUN_GROUP surface_at  // position of the group in the list
#define RUN_LENGTH pixels_at

shared uint runs_of[THREADS];

// run_place becomes that of its group's first pixel.
void place_groups() {
  for (uint r = 0u; r < bitCount(run_starts); ++r) {
    const uint place = run_place[r] == kFree ? kNowhere : pixels_at[run_place[r] >> kSlotBits];
    run_place[r] = place;
    if (place == kNowhere) continue;
    const uint at = position_of(place);
    run_place[r] = place - at + group_start(at);
  }
}

// `place` moved on by the runs of the group that are before run k.
uint behind(uint place, uint k, uint first_run) {
#ifdef MUTANT_26  // a run looks at its neighbours alone
  for (uint j = first_run; j < k; ++j)
#else
  for (uint j = 0u; j < k; ++j)
#endif
    if (RUN_GROUP[j] == RUN_GROUP[k]) place += RUN_LENGTH[j];
  return place;
}

void list_pixels(uint tile) {
  const uint thread = gl_LocalInvocationID.x;
  place_groups();
  runs_of[thread] = bitCount(run_starts);
  barrier();
  uint first_run = 0u;
  for (uint t = 0u; t < thread; ++t) first_run += runs_of[t];
  uint k = first_run;
  for (uint rest = run_starts; rest != 0u; rest &= rest - 1u) {
    RUN_GROUP[k] = run_place[k - first_run];
    RUN_LENGTH[k] = bitCount(pixels_of_run(rest));
    ++k;
  }
  barrier();
  k = first_run;
  for (uint rest = run_starts; rest != 0u; rest &= rest - 1u) {
    uint place = RUN_GROUP[k] == kNowhere ? kNowhere : behind(RUN_GROUP[k], k, first_run);
    for (uint counted = place == kNowhere ? 0u : pixels_of_run(rest); counted != 0u; counted &= counted - 1u, ++place) {
      const uint i = findLSB(counted);
      list_pixel(tile, place, first_pixel() + i, copies_of_pixel(pixel_of_thread(i)));
    }
    ++k;
  }
}
