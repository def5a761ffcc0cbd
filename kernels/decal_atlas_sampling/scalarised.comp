#version 460
// The wave walks the union of its pixels' lists in ascending order, a decal a turn, so that the decal's record is the
// same for all lanes (Sousa, Geffroy 2016, the serial walk). Where all lanes are in one cell they have one list. A list
// has kMaxClusterEntries entries, each turn passes one of a lane's at least: 128 * 256 turns at most.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "kernels/decal_atlas_sampling/lists.glsl"

const uint kNone = 0xffffffffu;

uint next_of(List l) { return l.at < l.end ? decal_of(entries[l.at]) : kNone; }

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  const float d = depth_at(pixel);
  if (d == 0.0) return;  // the subgroup's operations are among those that stay
  const Point p = point_at(pixel, d);
  Material m = load_material(pixel);
  const uint cell = cell_of(params.grid, pixel, d);
  if (subgroupAllEqual(cell)) {
    const List l = list_of(subgroupBroadcastFirst(cell));
    for (uint i = l.at; i < l.end; ++i) apply_decal(m, decal_of(entries[i]), p);
  } else {
    List l = list_of(cell);
    uint mine = next_of(l), next = subgroupMin(mine);
    while (next != kNone) {
#ifdef MUTANT_16  // every lane of the wave takes the decal
      apply_decal(m, next, p);
#else
      if (mine == next) apply_decal(m, next, p);
#endif
      if (mine == next) {
        ++l.at;
        mine = next_of(l);
      }
      next = subgroupMin(mine);
    }
  }
  store_material(pixel, m);
}
