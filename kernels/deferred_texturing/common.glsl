// What every texturing shader binds: from a pixel to the material that it shows, and where that is sampled.
#ifndef DEFERRED_TEXTURING_COMMON
#define DEFERRED_TEXTURING_COMMON
#include "harness/glsl/ports.glsl"
#include "harness/formats/visibility.h"
#include "harness/glsl/attributes.glsl"
#include "kernels/deferred_texturing/layout.h"
#define TEXTURES_SLOT 8
#include "harness/glsl/textures.glsl"

layout(binding = 0) uniform utexture2D visibility;
READS(1, SurfaceRecord, surfaces);
READS(2, MaterialRecord, materials);
READS(3, uint, indices);
READS(4, VertexAttributes, vertices);
READS(5, uint, barycentrics);
READS(6, uvec2, derivatives);
READS(7, uvec2, tangent_frame);
PARAMS(TexturingParams);

#ifdef MUTANT_1  // the last column is left out
bool on_screen(uvec2 pixel) { return pixel.x + 1u < params.width && pixel.y < params.height; }
#else
bool on_screen(uvec2 pixel) { return pixel.x < params.width && pixel.y < params.height; }
#endif
uint pixel_number(uvec2 pixel) { return pixel.y * params.width + pixel.x; }

// Triangle and surface; a surface at or above the count is none.
uvec2 visible_at(uvec2 pixel) {
#ifdef MUTANT_2  // the instanced flag counts as part of the surface
  return texelFetch(visibility, ivec2(pixel), 0).xy & uvec2(0xffffffffu, ~kVisibilityFlipped);
#else
  return texelFetch(visibility, ivec2(pixel), 0).xy & uvec2(0xffffffffu, kVisibilitySurfaceMask);
#endif
}

// What textures a surface; shader is kUnregistered where nothing does: a surface, material or class that there is not.
struct Look {
  uint material;
  uint shader;
};
Look look_of(uint surface) {
#ifdef MUTANT_3  // one surface too many, the last again
  if (surface > params.surfaces) return Look(kNoMaterial, kUnregistered);
  const uint material = surfaces[min(surface, params.surfaces - 1u)].material;
#else
  if (surface >= params.surfaces) return Look(kNoMaterial, kUnregistered);
  const uint material = surfaces[surface].material;
#endif
  if (material >= params.materials) return Look(kNoMaterial, kUnregistered);
  const uint shader = materials[material].shader;
  const bool is_visible = shader < kShaderClasses && params.slot_of_class[shader] != kUnregistered;
  return Look(material, is_visible ? shader : kUnregistered);
}

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

// Of the k-th vertex of a triangle; indices past the end are the last.
vec2 vertex_uv(SurfaceRecord s, uint triangle, uint k) {
#ifdef MUTANT_5  // all meshes begin at the first vertex
  const uint index = indices[min(s.first_index + 3u * triangle + k, params.indices - 1u)];
#else
  const uint index = indices[min(s.first_index + 3u * triangle + k, params.indices - 1u)] + s.vertex_offset;
#endif
  return vertices[min(index, params.vertices - 1u)].uv;
}

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
