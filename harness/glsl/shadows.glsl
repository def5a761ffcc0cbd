// The one shadow lookup, for every kind of light (Sousa, Geffroy 2016): percentage-closer filtering (Reeves, Salesin,
// Cook 1987) of one view's tile in the atlas. Its maths and bounds are in kernels/shadow_lookup/README.md. Before
// including, a shader declares the ports `shadow_views` (ShadowView) and `shadow_depth` (texture2D), and defines
//   SHADOW_VIEWS   how many views there are
//   SHADOW_EXTENT  the atlas's, texels (uvec2)
//   SHADOW_FILTER  taps a side, 2 at least
// Loop turns of a lookup: taps, and 4 cascades.
#ifndef HARNESS_GLSL_SHADOWS
#define HARNESS_GLSL_SHADOWS
#include "harness/formats/light.h"
#include "harness/formats/shadow.h"

// Interleaved gradient noise (Jimenez 2014), fract(52.9829189 fract(0.06711056 x + 0.00583715 y)), shifted by 5.588238
// pixels a frame; in units of 2^-32 that wrap, so that it is the same number everywhere.
float shadow_dither(uvec2 pixel, uint frame) {
  const uint inner = pixel.x * 288237660u + pixel.y * 25070368u + frame * 1750839832u;
  uint high, low;
  umulExtended(inner, 4221604530u, high, low);
  return float((inner * 52u + high) >> 8) * 5.9604644775390625e-8;  // 2^-24
}

float shadow_row(vec4 row, vec3 position) { return dot(row.xyz, position) + row.w; }

// Of the cube's faces, the one that a direction points at; of equal axes the first.
uint shadow_face(vec3 direction) {
  const vec3 size = abs(direction);
  if (size.x >= size.y && size.x >= size.z) return direction.x < 0.0 ? 1u : 0u;
#ifdef MUTANT_9701  // up and down change places
  if (size.y >= size.z) return direction.y < 0.0 ? 2u : 3u;
#else
  if (size.y >= size.z) return direction.y < 0.0 ? 3u : 2u;
#endif
  return direction.z < 0.0 ? 5u : 4u;
}

// Whether a cascade's tile holds a position with all of its filter; near the rim for some dithers only.
bool shadow_holds(ShadowView view, vec3 position, float dither) {
  const float side = float(view.tile.side);
#ifdef MUTANT_9702  // no dither
  const float most = side;
#else
  const float most = side - side * (kCascadeBand * dither);
#endif
#ifdef MUTANT_9703  // the filter has no width
  const float rim = most;
#else
  const float rim = most - float(SHADOW_FILTER - 1);
#endif
  return abs(shadow_row(view.clip_x, position)) * side <= rim && abs(shadow_row(view.clip_y, position)) * side <= rim;
}

bool is_in_atlas(ShadowTile tile) {
  const uvec2 extent = SHADOW_EXTENT;
  return tile.side != 0u && tile.side <= min(extent.x, extent.y) && tile.x <= extent.x - tile.side &&
         tile.y <= extent.y - tile.side;
}

const float kLeastShadowRay = 1e-36;  // rows so small that their product's square is less have no slope

// How a view's depth changes on the plane with this normal, a unit of x and y in [-1, 1]; 0 of no normal. The rows at
// the point, less its x, y and depth times w's, are how these three change with the position, so the quotients of
// triple products are how depth changes with x and y while the plane is not left. Where the plane is nearly in line
// with the light, they are held (README, Slope).
vec2 shadow_slope(ShadowView view, vec3 at, vec3 normal) {
  const vec3 a = view.clip_x.xyz - at.x * view.clip_w.xyz, b = view.clip_y.xyz - at.y * view.clip_w.xyz,
             c = view.clip_z.xyz - at.z * view.clip_w.xyz;
  const vec3 ray = cross(a, b);
  const float facing = dot(normal, ray), least = kLeastShadowFacing * kLeastShadowFacing * dot(ray, ray);
#ifdef MUTANT_9704  // the other way along y
  const vec2 change = vec2(dot(normal, cross(c, b)), dot(normal, cross(c, a)));
#else
  const vec2 change = vec2(dot(normal, cross(c, b)), dot(normal, cross(a, c)));
#endif
#ifdef MUTANT_9705  // not held
  return change / facing;
#else
  return change * (facing / max(max(facing * facing, least), kLeastShadowRay));
#endif
}

// The share of taps that see the light, each weighted by how much of its texel is within SHADOW_FILTER - 1 texels
// about the position. A position that the view does not see is lit.
float shadow_in_view(ShadowView view, vec3 position, vec3 normal, bool is_linear) {
  if (!is_in_atlas(view.tile)) return 1.0;
  const float w = shadow_row(view.clip_w, position);
#ifdef MUTANT_9706  // behind the light as before it
  if (w == 0.0) return 1.0;
#else
  if (!(w > 0.0 && w < kMostShadowNumber)) return 1.0;
#endif
  vec3 at = vec3(shadow_row(view.clip_x, position), shadow_row(view.clip_y, position),
                 shadow_row(view.clip_z, position)) / w;
  if (!(abs(at.x) <= kMostShadowOutside && abs(at.y) <= kMostShadowOutside)) return 1.0;
  if (!(at.z < 1.0 && at.z > -kMostShadowNumber)) return 1.0;
  at.z = max(at.z, 0.0);

  const float half_side = 0.5 * float(view.tile.side);
  const vec2 slope = shadow_slope(view, at, normal) / half_side;  // a texel
  const float steep = abs(slope.x) + abs(slope.y);
#ifdef MUTANT_9707  // no room for rounding
  const float depth = at.z;
#else
  const float depth = at.z + view.bias * ((is_linear ? 1.0 : at.z) + steep * half_side) +
                      steep * (float(SHADOW_FILTER + 1) * kShadowSnap);
#endif
  const vec2 texel = (at.xy + 1.0) * half_side, corner = texel - 0.5 * float(SHADOW_FILTER - 1);
  const ivec2 first = ivec2(floor(corner)), last = ivec2(int(view.tile.side) - 1);
  const vec2 part = corner - floor(corner);
  const uint taps = uint(SHADOW_FILTER);
  float dark = 0.0;
  for (uint i = 0u; i < taps * taps; ++i) {
    const uvec2 tap = uvec2(i % taps, i / taps);
#ifdef MUTANT_9708  // into the neighbour's tile
    const ivec2 in_tile = first + ivec2(tap);
#else
    const ivec2 in_tile = clamp(first + ivec2(tap), ivec2(0), last);
#endif
    const float stored = texelFetch(shadow_depth, ivec2(view.tile.x, view.tile.y) + in_tile, 0).r;
#ifdef MUTANT_9709  // a texel's corner for its centre
    const vec2 away = vec2(in_tile) - texel;
#else
    const vec2 away = vec2(in_tile) + 0.5 - texel;
#endif
    const vec2 ends = mix(vec2(1.0), 1.0 - part, equal(tap, uvec2(0u)));
#ifdef MUTANT_9710  // the last tap counts in full
    const vec2 weight = ends;
#else
    const vec2 weight = mix(ends, part, equal(tap, uvec2(taps - 1u)));
#endif
#ifdef MUTANT_9711  // what has no depth is a caster too
    const bool is_caster = true;
#else
    const bool is_caster = stored > 0.0;
#endif
    if (is_caster && stored > depth + dot(slope, away)) dark += weight.x * weight.y;
  }
  return max(1.0 - dark / float((taps - 1u) * (taps - 1u)), 0.0);
}

// The share of a light that arrives at a position, 0..1. plane_normal: unit, of the plane that the position is part of,
// either way round; zero where there is none. dither: [0, 1), between cascades.
float shadow_at(LightRecord light, vec3 position, vec3 plane_normal, float dither) {
#ifdef MUTANT_9712  // views past the end
  uint views = light.views;
#else
  uint views = light.first_view < SHADOW_VIEWS ? min(light.views, SHADOW_VIEWS - light.first_view) : 0u;
#endif
  const bool is_directional = light.kind == kLightDirectional;
  uint view = 0u;
  if (is_directional) {
    views = min(views, kMostCascades);
    while (view < views && !shadow_holds(shadow_views[light.first_view + view], position, dither)) ++view;
  } else if (light.kind == kLightPoint) {
    view = shadow_face(position - light.position);
  }
  if (view >= views) return 1.0;
  return shadow_in_view(shadow_views[light.first_view + view], position, plane_normal, is_directional);
}
#endif
