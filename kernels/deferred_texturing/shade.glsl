// From a sampled material to a texel of the G-buffer.
#ifndef DEFERRED_TEXTURING_SHADE
#define DEFERRED_TEXTURING_SHADE
#include "kernels/deferred_texturing/classes.glsl"
#include "kernels/deferred_texturing/outputs.glsl"

bool is_seen_from_both_sides(MaterialRecord m) {
  return (m.flags & kMaterialDoubleSided) != 0u || m.shader == kShaderMasked || m.shader == kShaderFoliage;
}

// World; of a back face that is seen, its other side's.
vec3 shading_normal(Layer l, SurfaceAttributes a, bool both_sides) {
  const vec3 bitangent = cross(a.normal, a.tangent) * a.handedness;
  vec3 n = l.normal.x * a.tangent + l.normal.y * bitangent + l.normal.z * a.normal;
  const float squared = dot(n, n);
  const bool has_direction = !is_below(squared, kLeastNormal) && is_below(squared, kLargestNormal);
  n = has_direction ? n * inversesqrt(squared) : a.normal;
  return both_sides && !a.front_facing ? -n : n;
}

SurfaceAttributes attributes_at(uvec2 pixel) {
  const uint i = pixel_number(pixel);
  return decode_attributes(barycentrics[i], derivatives[i], tangent_frame[i]);
}

Texel texel_of(Layer l, SurfaceAttributes a, MaterialRecord m) {
  return Texel(encode_base_roughness(l.base, l.roughness),
               encode_normal(shading_normal(l, a, is_seen_from_both_sides(m))), vec2(l.metallic, l.occlusion),
               encode_emissive(l.emissive), m.features);
}
#endif
