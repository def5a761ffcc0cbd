// Sums over `SCANNED` neighbouring threads of a group of `THREADS`, a power of two each, which the includer defines.
shared uint sums[2][THREADS];

// Of the thread's own and those before it; `total` of all of them. Begins and ends apart from other uses of `sums`.
uint sum_through(uint own, out uint total) {
  const uint thread = gl_LocalInvocationID.x, member = thread % SCANNED;
  uint from = 0u;
  sums[from][thread] = own;
  barrier();
  for (uint reach = 1u; reach < SCANNED; reach *= 2u) {  // log2 of SCANNED steps, from one half of `sums` to the other
    const uint lower = member >= reach ? sums[from][thread - reach] : 0u;
    sums[1u - from][thread] = sums[from][thread] + lower;
    from = 1u - from;
#ifndef MUTANT_9821  // the barrier dropped: a step reads what the one before has yet to write
    barrier();
#endif
  }
  const uint through = sums[from][thread];
  total = sums[from][thread - member + SCANNED - 1u];
  barrier();
  return through;
}
