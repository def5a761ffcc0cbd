#version 460
// One dispatch for all levels: a group reduces its 32 x 32 pixels to five levels, and the one that ends last makes the
// others of what all have stored. Nobody waits for anybody: no forward progress is asked of the device.
// Loop turns of an invocation beyond those of a tile: texels of level 6 and on over 256 threads, 342 at most of 16,384
// pixels a side.
#include "kernels/hi_z/tile_shared.glsl"

UPDATES(2, uint, groups_done);
shared bool is_last;

void main() {
  reduce_tile(0u, gl_WorkGroupID.xy);
  memoryBarrierBuffer();
  barrier();
  const uint thread = gl_LocalInvocationID.x, groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
#ifdef MUTANT_10  // the group itself is not counted
  if (thread == 0u) is_last = atomicAdd(groups_done[0], 1u) == groups;
#else
  if (thread == 0u) is_last = atomicAdd(groups_done[0], 1u) + 1u == groups;
#endif
  barrier();
  if (!is_last) return;
#ifdef MUTANT_11  // the last level is left out
  for (uint level = kTileLevels + 1u; is_level(level + 1u); ++level) {
#else
  for (uint level = kTileLevels + 1u; is_level(level); ++level) {
#endif
    const uvec2 size = size_of(level);
    memoryBarrierBuffer();
    barrier();
    for (uint i = thread; i < size.x * size.y; i += 256u) {
      const uvec2 at = uvec2(i % size.x, i / size.x);
      store(level, at, range_below(level, at));
    }
  }
}
