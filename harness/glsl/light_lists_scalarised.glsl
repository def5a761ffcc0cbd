// The serial walk of Sousa, Geffroy 2016: a wave goes through all lights of its cells' lists in ascending order, each
// light once, with a uniform index; lanes whose list has it are lit. A wave in one cell walks its list as it is.
// Loop turns: a light of a lane's list each, 256 of 128 lanes.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_vote : require
#include "harness/glsl/light_lists.glsl"

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
#ifdef MUTANT_9832  // the first lane's light for the least of all
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

// `mine`: the lane's cell, or kNothing. Lanes without one go along with any other.
void walk_together(inout Lit lit, uint mine) {
  const uint cell = subgroupMin(mine);
  if (cell == kNothing) return;
#ifdef MUTANT_9833  // a wave of two cells taken for one of the first
  const bool one_cell = true;
#else
  const bool one_cell = subgroupAll(mine == cell || mine == kNothing);
#endif
  if (one_cell)
    walk_one(lit, list_of(cell), mine != kNothing);
  else
    walk_union(lit, mine == kNothing ? kNoList : list_of(mine));
}
