// The grid, the items, and how an interval of one is found beyond that of another.
#include "harness/glsl/ports.glsl"
#include "kernels/cluster_voxelization/layout.h"

READS(0, ClusterItem, items);
READS(1, float, edges);  // of columns x / z, of rows y / z, of slices z; each ascending
PARAMS(ClusterParams);

uint lights() { return min(params.lights, kMaxClusterLights); }
uint decals() { return min(params.decals, kMaxClusterDecals); }
uint probes() { return min(params.probes, kMaxClusterProbes); }
uint columns() { return min(params.columns, kMaxClusterColumns); }
uint rows() { return min(params.rows, kMaxClusterRows); }
uint slices() { return min(params.slices, kMaxClusterSlices); }

float column_edge(uint i) { return edges[i]; }
float row_edge(uint i) { return edges[columns() + 1u + i]; }
float slice_edge(uint i) { return edges[columns() + rows() + 2u + i]; }

// Rounding of a sum whose terms' magnitudes are `sum`: at most 7 roundings of each term (README, Error), and what a
// device may flush to zero on the way.
#ifdef MUTANT_1  // no room for rounding
float rounding(float sum) { return 0.0; }
#else
float rounding(float sum) { return sum * (8.0 / 16777216.0) + 1.0 / 1048576.0 / 1099511627776.0 / 1048576.0; }
#endif

// The item's interval along a direction m, and what the magnitudes of its terms add up to.
vec2 interval(ClusterItem item, vec3 m) {
  const float o = dot(m, item.origin), c = dot(m, item.c);
  const float flat_part = abs(dot(m, item.a)) + abs(dot(m, item.b));
#ifdef MUTANT_2  // the apex is forgotten
  if (item.shape == kShapePyramid) return o + c + vec2(-flat_part, flat_part);
#else
  if (item.shape == kShapePyramid) return vec2(min(o, o + c - flat_part), max(o, o + c + flat_part));
#endif
  const float reach = flat_part + abs(c);
  return o + vec2(-reach, reach);
}
float magnitudes(ClusterItem item, vec3 m) {
  return dot(abs(m), abs(item.origin) + abs(item.a) + abs(item.b) + abs(item.c));
}

// Of what lies between slopes x and y, at depth 1, along m, with room for rounding: four roundings of a term, and one
// of its product with a depth.
vec2 interval_at_one(vec2 x, vec2 y, vec3 m) {
  const vec2 along_x = m.x * x, along_y = m.y * y;
  const vec3 reach = vec3(max(abs(x.x), abs(x.y)), max(abs(y.x), abs(y.y)), 1.0);
  const float slack = rounding(dot(abs(m), reach));
  return vec2(min(along_x.x, along_x.y) + min(along_y.x, along_y.y) + m.z - slack,
              max(along_x.x, along_x.y) + max(along_y.x, along_y.y) + m.z + slack);
}
