// Vertices relative to the pixel's centre, in pixels (times w): there X and Y of the hit are 0, so weights are three 2x2
// determinants over their sum. Every difference of products is compensated.
#ifndef HARNESS_GLSL_INTERPOLATION_COMPENSATED
#define HARNESS_GLSL_INTERPOLATION_COMPENSATED
#include "harness/glsl/interpolation/products.glsl"
#include "harness/glsl/interpolation/rescale.glsl"
#include "harness/glsl/interpolation/weigh.glsl"

// Of a rescaled triangle: x and y of its vertices, and the determinant opposite each of them.
void recentre(bool fused, Triangle t, out vec3 x, out vec3 y, out vec3 areas) {
  for (uint k = 0u; k < 3u; ++k) {
    x[k] = difference_of_products(fused, t.half_extent.x, t.corners[k].x, t.offset.x, t.corners[k].z);
    y[k] = difference_of_products(fused, t.half_extent.y, t.corners[k].y, t.offset.y, t.corners[k].z);
  }
  areas = vec3(difference_of_products(fused, x[1], y[2], x[2], y[1]),
               difference_of_products(fused, x[2], y[0], x[0], y[2]),
               difference_of_products(fused, x[0], y[1], x[1], y[0]));
}

// `area` is the areas' sum.
Interpolated weigh_recentred(Triangle t, vec3 x, vec3 y, vec3 areas, float area) {
  return weigh(t, areas, area, vec4(y[2] - y[0], y[0] - y[1], x[0] - x[2], x[1] - x[0]));
}

Interpolated interpolate_compensated(Triangle t) {
  if (!rescale(t)) return degenerate();
  vec3 x, y, areas;
  recentre(multiply_add_is_fused(), t, x, y, areas);
  return weigh_recentred(t, x, y, areas, areas.x + areas.y + areas.z);
}
#endif
