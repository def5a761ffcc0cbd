// A ray through the pixel and two through its neighbours, each against the triangle in clip space (Moeller, Trumbore
// 1997); derivatives are the differences.
vec3 weights_along(vec3 v, vec3 a, vec3 b, vec3 ray, out float determinant) {
  const vec3 p = cross(ray, b);
  determinant = dot(a, p);
  const float inverse = 1.0 / determinant;
  const float along_a = dot(-v, p) * inverse, along_b = dot(ray, cross(-v, a)) * inverse;
  return vec3(1.0 - along_a - along_b, along_a, along_b);
}

Interpolated interpolate(Triangle t) {
  const vec3 v = t.corners[0], a = t.corners[1] - v, b = t.corners[2] - v;
  float determinant, unused;
  Interpolated r;
  r.weights = weights_along(v, a, b, vec3(t.offset / t.half_extent, 1.0), determinant);
  const vec3 right = weights_along(v, a, b, vec3((t.offset + vec2(1, 0)) / t.half_extent, 1.0), unused);
  const vec3 below = weights_along(v, a, b, vec3((t.offset + vec2(0, 1)) / t.half_extent, 1.0), unused);
  r.derivatives = vec4(right.yz - r.weights.yz, below.yz - r.weights.yz);
  r.clockwise = determinant < 0.0;
  return r;
}
