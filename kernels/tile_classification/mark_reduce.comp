#version 460
// One group a tile: a tree of ORs in shared memory and one store. No atomics, nothing to clear.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"
#include "kernels/tile_classification/tile_bits.glsl"

shared uint partial[THREADS];

void main() {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint tile = spread_group();
  if (tile >= tile_count(extent)) return;  // the whole group
  const uint thread = gl_LocalInvocationID.x;
  partial[thread] = bits_of_thread(tile, extent);
#ifdef MUTANT_4  // the upper half is left out
  for (uint half_count = THREADS / 4u; half_count > 0u; half_count /= 2u) {
#else
  for (uint half_count = THREADS / 2u; half_count > 0u; half_count /= 2u) {
#endif
#ifndef MUTANT_5  // the barrier dropped: partners of higher subgroups have not written yet
    barrier();
#endif
    if (thread < half_count) partial[thread] |= partial[thread + half_count];
  }
  if (thread == 0u) masks[tile] = partial[0];
}
