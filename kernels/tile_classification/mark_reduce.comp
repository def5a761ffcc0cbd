#version 460
// One group a tile: a tree of ORs in shared memory and one store. No atomics, nothing to clear. The tree is
// broad and low, for a barrier costs more than the loads that it saves: 256 partial masks need two, not eight.
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"
#include "kernels/tile_classification/tile_bits.glsl"

const uint kFan = 16u;
shared uint partial[THREADS];

void main() {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint tile = spread_group();
  if (tile >= tile_count(extent)) return;  // the whole group
  const uint thread = gl_LocalInvocationID.x;
  partial[thread] = bits_of_thread(tile, extent);
  for (uint count = THREADS; count > 1u;) {
    const uint next = (count + kFan - 1u) / kFan;
#ifndef MUTANT_5  // the barrier dropped: partners of higher subgroups have not written yet
    barrier();
#endif
#ifdef MUTANT_4  // the upper half is left out
    count /= 2u;
#endif
    if (thread < next)
      for (uint i = thread + next; i < count; i += next) partial[thread] |= partial[i];
    count = next;
  }
  if (thread == 0u) masks[tile] = partial[0];
}
