#version 460
// The serial walk of Sousa, Geffroy 2016: a wave goes through all lights of its cells' lists in ascending order, each
// light once, with a uniform index; lanes whose list has it are lit. A wave in one cell walks its list as it is.
// Loop turns of an invocation: a light of a lane's list each, 256 of 128 lanes.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_vote : require
#include "kernels/deferred_lighting/lists.glsl"

layout(local_size_x = 256) in;

const uint kNothing = 0xffffffffu;

void walk_one(inout Lit lit, List list, bool is_lit) {
  for (uint i = 0u; i < list.count; ++i) {
    const uint light = light_in(list.first + i);
    if (is_lit) add_light(lit, light);
  }
}

void walk_union(inout Lit lit, List list) {
  uint at = 0u;
  for (;;) {
    const uint mine = at < list.count ? light_in(list.first + at) : kNothing;
#ifdef MUTANT_16  // the first lane's light for the least of all
    const uint next = subgroupBroadcastFirst(mine);
#else
    const uint next = subgroupMin(mine);
#endif
    if (next == kNothing) break;
    if (mine == next) {
      add_light(lit, next);
      ++at;
    }
  }
}

void main() {
  const uvec2 pixel = gl_WorkGroupID.xy * 16u + in_tile(gl_LocalInvocationIndex);
  const float d = depth_at(pixel);
  const bool is_lit = d != 0.0;
  Lit lit;
  if (is_lit) lit = start(pixel, d);
  // Lanes without a surface go along with any other.
  const uint mine = is_lit ? cell_at(pixel, d) : kNothing;
  const uint cell = subgroupMin(mine);
  if (cell != kNothing) {
#ifdef MUTANT_17  // a wave of two cells taken for one of the first
    const bool one_cell = true;
#else
    const bool one_cell = subgroupAll(mine == cell || !is_lit);
#endif
    if (one_cell)
      walk_one(lit, list_of(cell), is_lit);
    else
      walk_union(lit, is_lit ? list_of(mine) : kNoList);
  }
  if (!on_screen(pixel)) return;
  if (is_lit)
    store(pixel, texel_of(lit.radiance));
  else
    store_background(pixel);
}
