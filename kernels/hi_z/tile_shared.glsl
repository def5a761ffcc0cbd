// A group reduces 32 x 32 texels of level `below` to five levels: a thread 2 x 2, the rest in shared memory.
#include "kernels/hi_z/tile.glsl"

void reduce_tile(uint below, uvec2 tile) {
  const uint thread = gl_LocalInvocationID.x;
  const uvec2 range = range_below(below + 1u, tile * 16u + morton(thread));
  store_in_tile(below, 1u, tile, thread, range);
  of_tile[thread] = range;
  reduce_in_shared(below, 2u, tile, thread);
}
