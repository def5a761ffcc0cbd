// Where a pixel's textures are sampled.
#ifndef DEFERRED_TEXTURING_FOOTPRINT
#define DEFERRED_TEXTURING_FOOTPRINT
#include "kernels/deferred_texturing/common.glsl"
#include "harness/glsl/attributes.glsl"
READS(3, uint, indices);
READS(4, VertexAttributes, vertices);

// Smaller in magnitude than a positive limit; false for NaN on any device, for it compares integers.
bool is_below(float x, float limit) { return (floatBitsToUint(x) & 0x7fffffffu) < floatBitsToUint(limit); }

// Where a texture is sampled, and over how much of it, a pixel.
struct Footprint {
  vec2 uv;
  vec2 d_dx;
  vec2 d_dy;
};
float usable_uv(float x) { return is_below(x, kLargestUv) ? x : 0.0; }
float usable_gradient(float x) { return is_below(x, kLargestGradient) ? x : kLargestGradient; }
vec2 usable_gradient(vec2 d) { return vec2(usable_gradient(d.x), usable_gradient(d.y)); }
Footprint footprint(vec2 uv, vec2 d_dx, vec2 d_dy) {
  return Footprint(vec2(usable_uv(uv.x), usable_uv(uv.y)), usable_gradient(d_dx), usable_gradient(d_dy));
}

// The k-th vertex of a triangle; indices past the end are the last.
uint vertex_of(SurfaceRecord s, uint triangle, uint k) {
#ifdef MUTANT_5  // all meshes begin at the first vertex
  const uint index = indices[min(s.first_index + 3u * triangle + k, params.indices - 1u)];
#else
  const uint index = indices[min(s.first_index + 3u * triangle + k, params.indices - 1u)] + s.vertex_offset;
#endif
  return min(index, params.vertices - 1u);
}
vec2 vertex_uv(SurfaceRecord s, uint triangle, uint k) { return vertices[vertex_of(s, triangle, k)].uv; }

Footprint footprint_of(SurfaceRecord s, uint triangle, SurfaceAttributes a) {
  const vec2 origin = vertex_uv(s, triangle, 0u);
  const vec2 u1 = vertex_uv(s, triangle, 1u) - origin, u2 = vertex_uv(s, triangle, 2u) - origin;
#ifdef MUTANT_6  // only the way across is minified
  return footprint(origin + a.barycentrics.y * u1 + a.barycentrics.z * u2, a.d_dx.y * u1 + a.d_dx.z * u2, vec2(0));
#elif defined(MUTANT_7)  // the third vertex counts as the second
  return footprint(origin + a.barycentrics.y * u1 + a.barycentrics.z * u1, a.d_dx.y * u1 + a.d_dx.z * u2,
                   a.d_dy.y * u1 + a.d_dy.z * u2);
#else
  return footprint(origin + a.barycentrics.y * u1 + a.barycentrics.z * u2, a.d_dx.y * u1 + a.d_dx.z * u2,
                   a.d_dy.y * u1 + a.d_dy.z * u2);
#endif
}
#endif
