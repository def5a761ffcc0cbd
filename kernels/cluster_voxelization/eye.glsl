// Planes through the eye and an edge.

vec3 sums(vec3 p, vec3 q) {  // of the magnitudes of a cross product's terms
  return vec3(p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x);
}
vec3 reach_of(ClusterItem item) { return abs(item.origin) + abs(item.a) + abs(item.b) + abs(item.c); }

// How far from a plane what lies in it may seem to be: 13 roundings of the terms of the plane's normal, times what it is
// multiplied with; 16 are given.
float room_of(vec3 of_normal, vec3 reach) { return 2.0 * rounding(dot(of_normal, reach)); }
