// The last steps of the recentred formulas: weights from the three areas, derivatives from them. The README, "Formula".
#ifndef HARNESS_GLSL_INTERPOLATION_WEIGH
#define HARNESS_GLSL_INTERPOLATION_WEIGH
#include "harness/glsl/interpolation/triangle.glsl"

// areas: twice the signed areas that the pixel's centre spans with each edge, times two w; area: their sum; differences:
// y2 - y0, y0 - y1, x0 - x2, x1 - x0 of the corners relative to the centre, pixels times w.
Interpolated weigh(Triangle t, vec3 areas, float area, vec4 differences) {
  Interpolated r = degenerate();
  const float side = area < 0.0 ? -1.0 : 1.0;
  // Coverage was decided on a grid of 1/256 px, so a centre may lie outside: it gets the weights of a point inside.
#ifdef MUTANT_9107  // weights below 0 stay
  const vec3 inside = side * areas;
#else
  const vec3 inside = max(side * areas, 0.0);
#endif
  const float sum = inside.x + inside.y + inside.z;
  if (!(sum >= kSmallestArea)) return r;
  r.clockwise = area > 0.0;
  const float inverse = 1.0 / sum;
  r.weights = inside * inverse;
  // A hit behind the eye (w < 0) is none: no derivatives.
  float w = r.weights.x * t.corners[0].z + r.weights.y * t.corners[1].z + r.weights.z * t.corners[2].z;
#ifndef MUTANT_9108  // such a hit has derivatives
  w = max(w, 0.0);
#endif
#ifdef MUTANT_9109  // not times w
  r.derivatives = side * inverse * differences;
#elif defined(MUTANT_9110)  // along y the other way round
  r.derivatives = w * side * inverse * vec4(differences.xy, -differences.zw);
#else
  r.derivatives = w * side * inverse * differences;
#endif
  return r;
}
#endif
