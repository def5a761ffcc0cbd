// Relative to the pixel's centre by way of one vertex and two edges, with single multiply-adds: the cheapest form that
// bears small triangles. Weights are not kept inside; the packing does that.
#include "harness/glsl/interpolation/rescale.glsl"

Interpolated interpolate(Triangle t) {
  Interpolated r = degenerate();
  if (!rescale(t)) return r;
  const vec3 v = t.corners[0], a = t.corners[1] - v, b = t.corners[2] - v;
  const vec2 h = t.half_extent, o = t.offset;
  const float vx = fma(h.x, v.x, -(o.x * v.z)), vy = fma(h.y, v.y, -(o.y * v.z));
  const float ax = fma(h.x, a.x, -(o.x * a.z)), ay = fma(h.y, a.y, -(o.y * a.z));
  const float bx = fma(h.x, b.x, -(o.x * b.z)), by = fma(h.y, b.y, -(o.y * b.z));
  const float area = fma(ax, by, -(bx * ay));
  if (!(abs(area) >= kSmallestArea)) return r;
  r.clockwise = area > 0.0;
  const float inverse = 1.0 / area;
  r.weights.y = fma(bx, vy, -(vx * by)) * inverse;
  r.weights.z = fma(vx, ay, -(ax * vy)) * inverse;
  r.weights.x = 1.0 - r.weights.y - r.weights.z;
  const float w = max(v.z + r.weights.y * a.z + r.weights.z * b.z, 0.0);
#ifdef MUTANT_15
  r.derivatives = w * inverse * vec4(by, ay, -bx, ax);
#else
  r.derivatives = w * inverse * vec4(by, -ay, -bx, ax);
#endif
  return r;
}
