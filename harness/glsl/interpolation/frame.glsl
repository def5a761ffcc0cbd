// The tangent frame in world space, on the side that the mesh says.
#ifndef HARNESS_GLSL_INTERPOLATION_FRAME
#define HARNESS_GLSL_INTERPOLATION_FRAME
#include "harness/glsl/interpolation/triangle.glsl"
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

// v: the triangle's vertices; flipped: the surface's transform mirrors.
TangentFrame frame_of(SurfaceRecord s, bool flipped, VertexAttributes v[3], vec3 weights) {
  const vec3 no_normal = vec3(0, 0, 1), no_tangent = vec3(1, 0, 0);
  vec3 n = vec3(0), along_u = vec3(0);
  for (uint k = 0u; k < 3u; ++k) {
    n += weights[k] * v[k].normal;
    along_u += weights[k] * v[k].tangent.xyz;
  }
  const vec3 x = s.world_x.xyz, y = s.world_y.xyz, z = s.world_z.xyz;
  // Normals go by the cofactors of the transform, which turn them inside out where it mirrors.
#ifdef MUTANT_9111  // a mirror does not turn it
  const float side = 1.0;
#else
  const float side = flipped ? -1.0 : 1.0;
#endif
#ifdef MUTANT_9112  // by the transform
  const vec3 world = vec3(dot(x, n), dot(y, n), dot(z, n));
#else
  const vec3 world = side * vec3(dot(cross(y, z), n), dot(cross(z, x), n), dot(cross(x, y), n));
#endif
  return TangentFrame(direction_or(world, no_normal),
                      direction_or(vec3(dot(x, along_u), dot(y, along_u), dot(z, along_u)), no_tangent),
                      v[0].tangent.w < 0.0);
}
#endif
