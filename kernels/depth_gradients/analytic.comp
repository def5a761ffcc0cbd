#version 460
// From the plane of the triangle that the pixel shows.
#include "kernels/depth_gradients/common.glsl"

layout(binding = 0) uniform utexture2D visibility;
READS(1, vec3, positions);
READS(2, uint, indices);
READS(3, SurfaceRecord, surfaces);

#include "harness/glsl/interpolation/compensated.glsl"
#include "harness/glsl/interpolation/shown.glsl"

// With corners (x, y, w) relative to the pixel's centre, x and y in pixels times w, 1/w is linear over the screen and its
// gradient over itself is that of the plane's normal: (n.x, n.y) / n.z (README, How).
vec2 gradient_of(Triangle t) {
  if (!rescale(t)) return vec2(0.0);
  const bool fused = multiply_add_is_fused();
  vec3 x, y, areas;
  recentre(fused, t, x, y, areas);
  const vec3 a = vec3(x[1] - x[0], y[1] - y[0], t.corners[1].z - t.corners[0].z),
             b = vec3(x[2] - x[0], y[2] - y[0], t.corners[2].z - t.corners[0].z);
#ifdef MUTANT_2  // along y the other way round
  const vec2 n = vec2(difference_of_products(fused, a.y, b.z, a.z, b.y), difference_of_products(fused, a.x, b.z, a.z, b.x));
#elif defined(MUTANT_3)  // depths are taken for equal
  const vec2 n = vec2(0.0);
#elif defined(MUTANT_4)  // x and y change places
  const vec2 n = vec2(difference_of_products(fused, a.z, b.x, a.x, b.z), difference_of_products(fused, a.y, b.z, a.z, b.y));
#else
  const vec2 n = vec2(difference_of_products(fused, a.y, b.z, a.z, b.y), difference_of_products(fused, a.z, b.x, a.x, b.z));
#endif
#ifdef MUTANT_5  // the third vertex's area is left out
  const float area = areas.x + areas.y;
#else
  const float area = areas.x + areas.y + areas.z;
#endif
#ifdef MUTANT_6  // what has no area divides by it
  return n * (1.0 / area);
#elif defined(MUTANT_7)  // clockwise triangles lean the other way
  if (!(abs(area) >= kSmallestArea)) return vec2(0.0);
  return n * (1.0 / abs(area));
#else
  if (!(abs(area) >= kSmallestArea)) return vec2(0.0);
  return n * (1.0 / area);
#endif
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (!on_screen(pixel)) return;
  Shown t;
  store_gradient(pixel, shown_at(pixel, texelFetch(visibility, ivec2(pixel), 0).xy, t) ? gradient_of(t.triangle) : vec2(0.0));
}
