#version 460
// One group a tile: subgroupOr, then one shared atomic a subgroup, and one store.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "harness/glsl/ports.glsl"
#include "kernels/tile_classification/layout.h"
#include "harness/glsl/tiles.glsl"
#include "kernels/tile_classification/tile_bits.glsl"

shared uint tile_bits;

void main() {
  const uvec2 extent = uvec2(params.width, params.height);
  const uint tile = spread_group();
  if (tile >= tile_count(extent)) return;  // the whole group
  if (gl_LocalInvocationID.x == 0u) tile_bits = 0u;
  barrier();
#ifdef MUTANT_6  // the elected lane's bits stand for its subgroup
  const uint together = bits_of_thread(tile, extent);
#else
  const uint together = subgroupOr(bits_of_thread(tile, extent));
#endif
  if (subgroupElect() && together != 0u) atomicOr(tile_bits, together);
#ifndef MUTANT_7  // the barrier dropped: stored before the higher subgroups have joined
  barrier();
#endif
  if (gl_LocalInvocationID.x == 0u) masks[tile] = tile_bits;
}
