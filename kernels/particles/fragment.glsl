// A fragment: where on the quad, how much of it is seen, and its colour. The includer defines
// `vec3 light_at(Place)`: what leaves a white particle there.
#include "kernels/particles/common.glsl"
#define SIDE in
#include "kernels/particles/passed.glsl"

layout(binding = 2) uniform texture2D depth;
layout(location = 0) out vec4 radiance;

struct Place {
  vec2 at;      // -1..1 of right and up
  float depth;  // view depth, metres
  vec3 position;
};

vec3 light_at(Place);

// Where the ray through the pixel's centre meets the quad's plane: exact arithmetic's perspective interpolation, by
// operations whose error is known, which an interpolator's is not.
Place place() {
#ifdef MUTANT_3  // the pixel's corner
  const vec2 pixel = floor(gl_FragCoord.xy);
#else
  const vec2 pixel = gl_FragCoord.xy;
#endif
  const vec3 ray = params.rays.corner + params.rays.across * pixel.x + params.rays.down * pixel.y;
  const float across = dot(normal, ray);
  Place p;
  p.at = vec2(dot(row_x, ray), dot(row_y, ray)) / across;
  p.depth = centre_normal / across;
  p.position = ray * p.depth;
  return p;
}

// 1 in the middle, 0 at the rim, where its slope is 0 too: what pixels an edge covers does not matter.
float profile(vec2 at) {
  const float inside = 1.0 - dot(at, at);
  if (!(inside > 0.0)) return 0.0;
#ifdef MUTANT_4  // a cone's foot
  return inside;
#else
  return inside * inside;
#endif
}

// Of the surface behind: 0 where it is in front, rising to 1 over the particle's softness.
float soft(float view_depth) {
  const float d = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
  if (!(d > kLeastDepth && is_finite(d))) return 1.0;
  const float gap = params.near_plane / d - view_depth;
#ifdef MUTANT_5  // particles behind a surface show through
  if (isnan(gap)) return 0.0;
#else
  if (!(gap > 0.0)) return 0.0;
#endif
#ifdef MUTANT_6  // no fade
  return 1.0;
#else
  return opacity_softness.y > 0.0 ? min(gap / opacity_softness.y, 1.0) : 1.0;
#endif
}

// From nothing on the near plane to all at twice its distance.
float near_fade(float view_depth) {
#ifdef MUTANT_7  // cut there
  return view_depth > params.near_plane ? 1.0 : 0.0;
#else
  return clamp(view_depth / params.near_plane - 1.0, 0.0, 1.0);
#endif
}

void main() {
  const Place p = place();
  const float alpha = opacity_softness.x * profile(p.at) * soft(p.depth) * near_fade(p.depth);
  if (!(alpha > 0.0)) discard;
#ifdef MUTANT_8  // albedo forgotten
  radiance = vec4(storable(light_at(p)), alpha);
#else
  radiance = vec4(storable(albedo * light_at(p)), alpha);
#endif
}
