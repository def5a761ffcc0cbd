// What every variant binds, a pixel's surface and its cell.
#ifndef DECAL_ATLAS_SAMPLING_COMMON
#define DECAL_ATLAS_SAMPLING_COMMON
#include "harness/glsl/gbuffer.glsl"
#include "kernels/decal_atlas_sampling/layout.h"
#include "harness/glsl/decal_tiles.glsl"

layout(binding = 0) uniform texture2D depth;
layout(binding = 1) uniform texture2D depth_gradients;
layout(binding = 2, r32ui) uniform restrict coherent uimage2D base_roughness;
layout(binding = 3, r32ui) uniform restrict coherent uimage2D normal;
READS(4, float, slice_edges);
READS(5, DecalRecord, decals);
READS(6, ReceiverRecord, receivers);
PARAMS(DecalParams);

#include "harness/glsl/clusters.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

struct Point {
  vec3 position;  // relative to the camera
  vec3 d_dx;      // of the position, a pixel
  vec3 d_dy;
  float distance;  // view depth
};

bool on_screen(uvec2 pixel) { return pixel.x < params.width && pixel.y < params.height; }

// The depth of a pixel that has a surface on the screen, else 0.
float depth_at(uvec2 pixel) {
  if (!on_screen(pixel)) return 0.0;
  const float d = texelFetch(depth, ivec2(pixel), 0).r;
  return takes_decals(d) ? d : 0.0;
}

// depth_gradients holds the gradient over the depth itself, by which the view depth shrinks: dw/w = -dd/d.
Point point_at(uvec2 pixel, float d) {
  const vec2 at = vec2(pixel) + 0.5;
  const vec3 ray = params.rays.corner + params.rays.across * at.x + params.rays.down * at.y;
  const vec2 gradient = texelFetch(depth_gradients, ivec2(pixel), 0).rg;
  const float w = params.near_plane / d;
#ifdef MUTANT_1  // as if every surface were square to the view
  return Point(w * ray, w * params.rays.across, w * params.rays.down, w);
#else
  return Point(w * ray, w * (params.rays.across - ray * gradient.x), w * (params.rays.down - ray * gradient.y), w);
#endif
}
#endif
