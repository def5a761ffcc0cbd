#version 460
// Each wave bounds the positions of its pixels by a box, its lanes test a light each against the box, and the wave walks
// what is left. A light is left out only where its window is 0 at every pixel, by a margin that rounding cannot cross:
// the sum loses nothing but zeros, and keeps its order.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "kernels/deferred_lighting/common.glsl"

layout(local_size_x = 256) in;

struct Box {
  vec3 low;
  vec3 high;
};

// The distance to the box and the range are each within 10u, the shader's own within the position's error, which is the
// same in both; 1e-4 is over a hundred times that. Comparisons with NaN fail: such a light stays.
bool out_of_reach(LightRecord light, Box box) {
  if (light.kind == kLightDirectional || !(light.range > 0.0)) return false;
  const vec3 gap = max(max(box.low - light.position, light.position - box.high), 0.0);
#ifdef MUTANT_11  // lights that reach the farther half of their range are left out
  return dot(gap, gap) > 0.25 * light.range * light.range;
#else
  return dot(gap, gap) > 1.0001 * (light.range * light.range);
#endif
}

void main() {
  const uvec2 pixel = gl_WorkGroupID.xy * 16u + in_tile(gl_LocalInvocationIndex);
  const float d = depth_at(pixel);
  Lit lit;
  Box box = Box(vec3(3e38), vec3(-3e38));
  if (d != 0.0) {
    lit = start(pixel, d);
    box = Box(lit.surface.position, lit.surface.position);
  }
#ifdef MUTANT_12  // the box of the wave's first lane alone
  box = Box(subgroupBroadcastFirst(box.low), subgroupBroadcastFirst(box.high));
#else
  box = Box(subgroupMin(box.low), subgroupMax(box.high));
#endif
  const uvec4 lanes = subgroupBallot(true);
  const uint width = subgroupBallotBitCount(lanes);
  const uint slot = subgroupBallotExclusiveBitCount(lanes);
  const uint count = light_count();
  // Every light takes one turn of the inner loop at most, and every `width` of them one of the outer.
  for (uint first = 0u; first < count; first += width) {
    const uint mine = first + slot;
    uvec4 left = subgroupBallot(mine < count && !out_of_reach(lights[min(mine, count - 1u)], box));
    while (left != uvec4(0u)) {
      const uint lane = subgroupBallotFindLSB(left);
#ifdef MUTANT_13  // every light that is left taken for the first
      const uint i = first;
#else
      const uint i = subgroupBroadcast(mine, lane);
#endif
      left[lane / 32u] &= left[lane / 32u] - 1u;
      if (d != 0.0) lit.radiance += lit_by(lit, lights[i]);
    }
  }
  if (!on_screen(pixel)) return;
  if (d == 0.0)
    store_background(pixel);
  else
    store(pixel, texel_of(lit.radiance));
}
