// The tangent frame in world space, on the side that the mesh says.
struct TangentFrame {
  vec3 normal, tangent;  // unit length
  bool left_handed;  // before a mirror; a triangle's, not a blend: the first vertex's
};

// Unit length, or `fallback` where a direction cannot be told: nothing, or a length beyond 2^+-100, or NaN.
vec3 direction_or(vec3 v, vec3 fallback) {
  float scale;
  if (!scale_for(magnitude_bits(v), scale)) return fallback;
  v *= scale;
  return v * inversesqrt(dot(v, v));
}

TangentFrame frame_of(Triangle t, vec3 weights) {
  const vec3 no_normal = vec3(0, 0, 1), no_tangent = vec3(1, 0, 0);
  if (!t.has_attributes) return TangentFrame(no_normal, no_tangent, false);
  vec3 n = vec3(0), along_u = vec3(0);
  for (uint k = 0u; k < 3u; ++k) {
    const VertexAttributes v = attributes[t.vertices[k]];
    n += weights[k] * v.normal;
    along_u += weights[k] * v.tangent.xyz;
  }
  const SurfaceRecord s = surfaces[t.surface];
  const vec3 x = s.world_x.xyz, y = s.world_y.xyz, z = s.world_z.xyz;
  // Normals go by the cofactors of the transform, which turn them inside out where it mirrors.
#ifdef MUTANT_7
  const float side = 1.0;
#else
  const float side = t.flipped ? -1.0 : 1.0;
#endif
#ifdef MUTANT_8
  const vec3 world = vec3(dot(x, n), dot(y, n), dot(z, n));
#else
  const vec3 world = side * vec3(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n));
#endif
  return TangentFrame(direction_or(world, no_normal),
                      direction_or(vec3(dot(x, along_u), dot(y, along_u), dot(z, along_u)), no_tangent),
                      attributes[t.vertices.x].tangent.w < 0.0);
}
