// What every variant binds, and all of a pixel but its loop over the lights. SHADOWED: lights with views in the shadow
// atlas shed what it lets through.
#ifndef DEFERRED_LIGHTING_COMMON
#define DEFERRED_LIGHTING_COMMON
#define GBUFFER_READS 1
#include "harness/glsl/gbuffer.glsl"
#include "harness/glsl/lighting.glsl"
#include "harness/glsl/ports.glsl"
#include "kernels/deferred_lighting/layout.h"

layout(binding = 0) uniform texture2D depth;
READS(5, uint, features);
READS(6, LightRecord, lights);
layout(binding = 7, rgba16f) uniform writeonly restrict image2D radiance;
PARAMS(LightingParams);
#ifdef SHADOWED
READS(14, ShadowView, shadow_views);
layout(binding = 15) uniform texture2D shadow_depth;
layout(binding = 16) uniform texture2D depth_gradients;
#define SHADOW_VIEWS params.shadow_views
#define SHADOW_EXTENT uvec2(params.shadow_width, params.shadow_height)
#define SHADOW_FILTER 3
#include "harness/glsl/shadows.glsl"
#endif

// Reversed depth: the farther, the nearer to 0; 0 is no surface, as are NaN and what is below every float's precision.
const float kLeastDepth = 1e-30;

// Pixels of a 16x16 tile in Morton order, so that waves of any width are as square as can be.
uvec2 in_tile(uint i) {
  uvec2 at = uvec2(i, i >> 1) & 0x55u;
  at = (at | at >> 1) & 0x33u;
  return (at | at >> 2) & 0x0fu;
}

bool on_screen(uvec2 pixel) {
#ifdef MUTANT_1
  return pixel.x + 1u < params.width && pixel.y < params.height;
#else
  return pixel.x < params.width && pixel.y < params.height;
#endif
}

uint light_count() { return min(params.lights, kMostLights); }

// The depth of a pixel that has a surface on the screen, else 0.
float depth_at(uvec2 pixel) {
  if (!on_screen(pixel)) return 0.0;
  const float d = texelFetch(depth, ivec2(pixel), 0).r;
  return d > kLeastDepth && is_finite(d) ? d : 0.0;
}

// To the view plane at distance 1, through the pixel's centre.
vec3 ray_of(uvec2 pixel) {
#ifdef MUTANT_2  // its corner
  const vec2 at = vec2(pixel);
#else
  const vec2 at = vec2(pixel) + 0.5;
#endif
  return params.rays.corner + params.rays.across * at.x + params.rays.down * at.y;
}

vec3 position_of(uvec2 pixel, float d) {
#ifdef MUTANT_3  // depth taken for distance
  return ray_of(pixel) * d;
#else
  return ray_of(pixel) * (params.near_plane / d);
#endif
}

struct Lit {
  Surface surface;
  vec3 radiance;  // so far: ambient light and emission
#ifdef SHADOWED
  vec3 plane_normal;
  float dither;
#endif
};

#ifdef SHADOWED
// Of the triangle's plane. Its depth changes by `gradient` of itself a pixel (kernels/depth_gradients), so a position w
// ray moves by w (across - gradient.x ray) and w (down - gradient.y ray): the product of these, less what cancels.
vec3 plane_normal_of(uvec2 pixel) {
  const vec3 ray = ray_of(pixel), across = params.rays.across, down = params.rays.down;
#ifdef MUTANT_26  // every plane faces the eye
  const vec2 gradient = vec2(0.0);
#elif defined(MUTANT_27)  // leans the other way
  const vec2 gradient = -texelFetch(depth_gradients, ivec2(pixel), 0).rg;
#else
  const vec2 gradient = texelFetch(depth_gradients, ivec2(pixel), 0).rg;
#endif
  const vec3 n = cross(across, down) + gradient.x * cross(down, ray) + gradient.y * cross(ray, across);
  return n * inversesqrt(max(dot(n, n), kLeastArea * kLeastArea));
}
#endif

// What leaves the surface of one light.
vec3 lit_by(Lit lit, LightRecord light) {
#ifdef SHADOWED
  return shade(lit.surface, light, shadow_at(light, lit.surface.position, lit.plane_normal, lit.dither));
#else
  return shade(lit.surface, light, 1.0);
#endif
}

// The direction to the eye comes from the ray alone: its precision does not depend on the depth's.
Lit start(uvec2 pixel, float d) {
  const GBufferTexel g = load_gbuffer(pixel);
  const uint bits = features[pixel.y * params.width + pixel.x];
  Lit lit;
  lit.surface = make_surface(position_of(pixel, d), g.normal, -unit_or_shorter(ray_of(pixel)), g.base_colour,
                             g.metallic, g.roughness, bits);
#ifdef MUTANT_4  // ambient light gets everywhere
  lit.radiance = g.emissive + shade_ambient(lit.surface, params.ambient);
#else
  lit.radiance = g.emissive + shade_ambient(lit.surface, params.ambient) * g.occlusion;
#endif
#ifdef SHADOWED
  lit.plane_normal = plane_normal_of(pixel);
#ifdef MUTANT_28  // every frame the same
  lit.dither = shadow_dither(pixel, 0u);
#else
  lit.dither = shadow_dither(pixel, params.frame);
#endif
#endif
  return lit;
}

const vec4 kBackground = vec4(0.0);

vec4 texel_of(vec3 colour) {
#ifdef MUTANT_5  // neither held above 0 nor below infinity
  return vec4(colour, 1.0);
#else
  return vec4(storable(colour), 1.0);
#endif
}
void store(uvec2 pixel, vec4 texel) { imageStore(radiance, ivec2(pixel), texel); }
void store_background(uvec2 pixel) {
#ifndef MUTANT_6  // the background is left as it was
  store(pixel, kBackground);
#endif
}
#endif
