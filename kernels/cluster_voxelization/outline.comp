#version 460
// A thread an item: the planes through the eye and those of its edges at which it ends for the eye, all of the item on
// one side. An edge in its midst is none; an edge that points to the eye, or of an item seen from the side, counts twice.
#include "kernels/cluster_voxelization/common.glsl"
#include "kernels/cluster_voxelization/eye.glsl"

layout(local_size_x = 64) in;
WRITES(2, Outline, outlines);
WRITES(3, vec4, outline_planes);  // kMaxOutline an item: inside is dot(xyz, p) <= w

ClusterItem item;
uint to = 0u, count = 0u;

// `on`: a point of the edge's line, a sum of up to three vectors; `reach`: of the direction's terms.
void add_edge(vec3 on, vec3 direction, vec3 reach) {
  const vec3 m = cross(on, direction);
  const vec2 there = interval(item, m);
  const float slack = rounding(magnitudes(item, m)), room = room_of(sums(reach_of(item), reach), reach_of(item));
#ifdef MUTANT_14  // an edge in its midst counts, as if all were on one side
  if (there.y <= room || there.x < -room) outline_planes[to + count++] = vec4(m, min(there.y, 0.0) + slack);
#else
  if (there.y <= room) outline_planes[to + count++] = vec4(m, max(there.y + slack, 0.0));
#endif
  if (there.x >= -room) outline_planes[to + count++] = vec4(-m, max(-there.x + slack, 0.0));
}

void add_round(vec3 middle, vec3 u, vec3 v) {
  add_edge(middle + v, u, abs(u));
  add_edge(middle - v, u, abs(u));
  add_edge(middle + u, v, abs(v));
  add_edge(middle - u, v, abs(v));
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= lights() + decals() + probes()) return;
  item = items[i];
  to = i * kMaxOutline;
  const vec2 depths = interval(item, vec3(0.0, 0.0, 1.0));
  const float slack = rounding(magnitudes(item, vec3(0.0, 0.0, 1.0)));
  add_round(item.origin + item.c, item.a, item.b);
  if (item.shape == kShapePyramid) {
    for (uint side = 0u; side < 4u; ++side) {
      const vec3 edge = item.c + ((side & 1u) == 0u ? item.a : -item.a) + (side < 2u ? item.b : -item.b);
      add_edge(item.origin, edge, abs(item.a) + abs(item.b) + abs(item.c));
    }
  } else {
    add_round(item.origin - item.c, item.a, item.b);
    add_edge(item.origin + item.a + item.b, item.c, abs(item.c));
    add_edge(item.origin + item.a - item.b, item.c, abs(item.c));
    add_edge(item.origin - item.a + item.b, item.c, abs(item.c));
    add_edge(item.origin - item.a - item.b, item.c, abs(item.c));
  }
  outlines[i] = Outline(max(depths.x - slack, 0.0), depths.y + slack, count);
}
