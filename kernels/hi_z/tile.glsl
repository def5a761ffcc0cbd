// Threads of a group of 256 in Morton order over 16 x 16 texels of the first level that a tile makes: four threads in a
// row, from a multiple of four on, are the four texels of one of the next level, and so on up to one texel.
#include "kernels/hi_z/common.glsl"

layout(local_size_x = 256) in;

const uint kTileLevels = 5u;  // 32 x 32 texels become one
shared uvec2 of_tile[256];

// Even bits of up to 8, together.
uint even_bits(uint v) {
  v &= 0x55u;
  v = (v | v >> 1u) & 0x33u;
  return (v | v >> 2u) & 0x0fu;
}
uvec2 morton(uint i) { return uvec2(even_bits(i), even_bits(i >> 1u)); }

// Of the tile's texels of level below + step the i-th: 16 x 16 of step 1, one of step 5.
void store_in_tile(uint below, uint step, uvec2 tile, uint i, uvec2 range) {
  store(below + step, tile * (32u >> step) + morton(i), range);
}

// The levels from `step` on; the tile's texels of the one before lie in of_tile, the barrier is still to come.
void reduce_in_shared(uint below, uint step, uvec2 tile, uint thread) {
  for (; step <= kTileLevels; ++step) {
    const uint texels = 1u << 2u * (kTileLevels - step);
#ifndef MUTANT_6  // the barrier dropped: what higher subgroups have yet to write is missing
    barrier();
#endif
    uvec2 range = kNothing;
#ifdef MUTANT_7  // three of four
    for (uint i = 0u; i < 3u && thread < texels; ++i) range = joined(range, of_tile[4u * thread + i]);
#else
    for (uint i = 0u; i < 4u && thread < texels; ++i) range = joined(range, of_tile[4u * thread + i]);
#endif
    barrier();
    if (thread < texels) {
      of_tile[thread] = range;
      store_in_tile(below, step, tile, thread, range);
    }
  }
}
