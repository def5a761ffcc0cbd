// From a sampled material to the G-buffer.
#ifndef DEFERRED_TEXTURING_SHADE
#define DEFERRED_TEXTURING_SHADE
#include "kernels/deferred_texturing/attributes.glsl"
#include "kernels/deferred_texturing/classes.glsl"
#include "kernels/deferred_texturing/store.glsl"

bool is_seen_from_both_sides(MaterialRecord m) {
#if (defined(HAS_MASKED) || defined(HAS_FOLIAGE)) && !defined(MUTANT_21)  // masked materials need the flag
  if (m.shader == kShaderMasked || m.shader == kShaderFoliage) return true;
#endif
  return (m.flags & kMaterialDoubleSided) != 0u;
}

// World; of a back face that is seen, its other side's.
vec3 shading_normal(vec3 tangent_space, SurfaceAttributes a, bool both_sides) {
#ifdef MUTANT_23  // mirrored UVs have no hand
  const vec3 bitangent = cross(a.normal, a.tangent);
#else
  const vec3 bitangent = cross(a.normal, a.tangent) * a.handedness;
#endif
  vec3 n = tangent_space.x * a.tangent + tangent_space.y * bitangent + tangent_space.z * a.normal;
  const float squared = dot(n, n);
  const bool has_direction = !is_below(squared, kLeastNormal) && is_below(squared, kLargestNormal);
#ifdef MUTANT_24  // a normal that is lost is no number
  n = n * inversesqrt(squared);
#else
  n = has_direction ? n * inversesqrt(squared) : a.normal;
#endif
#ifdef MUTANT_22  // back faces are turned that should not be
  return !a.front_facing ? -n : n;
#else
  return both_sides && !a.front_facing ? -n : n;
#endif
}

GBufferTexel texel_of(Layer l, SurfaceAttributes a, bool both_sides) {
  return GBufferTexel(l.base, l.roughness, shading_normal(l.normal, a, both_sides), l.metallic, l.occlusion,
                      l.emissive);
}
#endif
