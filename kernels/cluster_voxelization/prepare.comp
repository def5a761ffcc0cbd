#version 460
// A thread an item: the planes of its faces, and the columns, rows and slices that it reaches, first in bits 0..15 and last
// above; first beyond last where it reaches none.
// Loop turns of an invocation: the columns, the rows and the slices.
#include "kernels/cluster_voxelization/common.glsl"

layout(local_size_x = 64) in;
WRITES(2, uvec4, item_bounds);  // columns, rows, slices, planes
WRITES(3, vec4, item_planes);   // kMaxPlanes an item: inside is dot(xyz, p) <= w
UPDATES(4, uint, dropped_items);

const uint kNowhere = 1u;  // first 1, last 0

bool is_usable(vec3 v) {  // below 2^38; a NaN compares with nothing, so bits do
  const uvec3 exponents = floatBitsToUint(v) >> 23u & 0xffu;
#ifdef MUTANT_3  // infinities pass
  return all(lessThanEqual(exponents, uvec3(0xffu)));
#else
  return all(lessThan(exponents, uvec3(127u + 38u)));
#endif
}

// Whether all of the item lies beyond a plane through the eye, on the side of smaller slopes or of larger.
bool is_beyond(ClusterItem item, vec3 m, bool larger) {
  const vec2 there = interval(item, m);
  const float slack = rounding(magnitudes(item, m));
  return larger ? there.x > slack : there.y < -slack;
}

uint reached_columns(ClusterItem item) {
  uint first = kMaxClusterColumns, last = 0u;
  for (uint i = 0u; i < columns(); ++i) {
    if (is_beyond(item, vec3(1.0, 0.0, -column_edge(i)), false)) continue;
#ifdef MUTANT_4  // its left edge once more
    if (is_beyond(item, vec3(1.0, 0.0, -column_edge(i)), true)) continue;
#else
    if (is_beyond(item, vec3(1.0, 0.0, -column_edge(i + 1u)), true)) continue;
#endif
    first = min(first, i);
    last = i;
  }
  return first > last ? kNowhere : first | last << 16u;
}

uint reached_rows(ClusterItem item) {
  uint first = kMaxClusterRows, last = 0u;
  for (uint i = 0u; i < rows(); ++i) {
    if (is_beyond(item, vec3(0.0, 1.0, -row_edge(i)), false)) continue;
    if (is_beyond(item, vec3(0.0, 1.0, -row_edge(i + 1u)), true)) continue;
    first = min(first, i);
    last = i;
  }
  return first > last ? kNowhere : first | last << 16u;
}

uint reached_slices(ClusterItem item) {
  const vec3 forward = vec3(0.0, 0.0, 1.0);
  const vec2 depths = interval(item, forward);
  const float slack = rounding(magnitudes(item, forward));
  uint first = kMaxClusterSlices, last = 0u;
  for (uint i = 0u; i < slices(); ++i) {
    if (depths.y < slice_edge(i) - slack - rounding(abs(slice_edge(i)))) continue;
    if (depths.x > slice_edge(i + 1u) + slack + rounding(abs(slice_edge(i + 1u)))) continue;
    first = min(first, i);
#ifdef MUTANT_5  // the last slice is left out
    last = max(first, i) - uint(i > first);
#else
    last = i;
#endif
  }
  return first > last ? kNowhere : first | last << 16u;
}

// The face's plane with the item's farthest point on it; whatever rounding made of the direction, all of the item is inside.
vec4 face(ClusterItem item, vec3 n) {
  const float far = interval(item, n).y;
  return vec4(n, far + rounding(magnitudes(item, n)));
}

void write_box(uint item_index, ClusterItem item) {
  const vec3 normals[3] = vec3[](cross(item.b, item.c), cross(item.c, item.a), cross(item.a, item.b));
  for (uint i = 0u; i < 3u; ++i) {
    item_planes[item_index * kMaxPlanes + 2u * i] = face(item, normals[i]);
#ifdef MUTANT_6  // one side of each pair twice
    item_planes[item_index * kMaxPlanes + 2u * i + 1u] = face(item, normals[i]);
#else
    item_planes[item_index * kMaxPlanes + 2u * i + 1u] = face(item, -normals[i]);
#endif
  }
}

// Sides look away from the axis: along c they do not ascend.
void write_pyramid(uint item_index, ClusterItem item) {
  vec3 normals[5];
  normals[0] = cross(item.c + item.a, item.b);
  normals[1] = cross(item.c - item.a, item.b);
  normals[2] = cross(item.c + item.b, item.a);
  normals[3] = cross(item.c - item.b, item.a);
  for (uint i = 0u; i < 4u; ++i)
    if (dot(normals[i], item.c) > 0.0) normals[i] = -normals[i];
  normals[4] = cross(item.a, item.b);
  if (dot(normals[4], item.c) < 0.0) normals[4] = -normals[4];
  for (uint i = 0u; i < 5u; ++i) item_planes[item_index * kMaxPlanes + i] = face(item, normals[i]);
  item_planes[item_index * kMaxPlanes + 5u] = vec4(0.0);  // all is inside
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= lights() + decals() + probes()) return;
  const ClusterItem item = items[i];
  if (!is_usable(item.origin) || !is_usable(item.a) || !is_usable(item.b) || !is_usable(item.c)) {
    atomicAdd(dropped_items[0], 1u);
    item_bounds[i] = uvec4(kNowhere, kNowhere, kNowhere, 0u);
    for (uint p = 0u; p < kMaxPlanes; ++p) item_planes[i * kMaxPlanes + p] = vec4(0.0, 0.0, 0.0, -1.0);  // nothing is inside
    return;
  }
  item_bounds[i] = uvec4(reached_columns(item), reached_rows(item), reached_slices(item), 0u);
  if (item.shape == kShapePyramid)
    write_pyramid(i, item);
  else
    write_box(i, item);
}
