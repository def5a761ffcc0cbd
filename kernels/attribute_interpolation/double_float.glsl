// As the compensated formula; where that is ill-conditioned, in pairs of floats (Joldes, Muller, Popescu 2017). Such
// triangles are rare, and a wave without one does not pay.
#include "harness/glsl/interpolation/compensated.glsl"

struct Pair {
  float high, low;
};
Pair two_sum(float a, float b) {
  precise const float s = a + b;
  precise const float bb = s - a;
  precise const float error = (a - (s - bb)) + (b - bb);
  return Pair(s, error);
}
Pair quick_two_sum(float a, float b) {  // |a| >= |b|
  precise const float s = a + b;
  precise const float error = b - (s - a);
  return Pair(s, error);
}
Pair two_product(bool fused, float a, float b) {
  precise const float p = a * b;
  if (!fused) return Pair(p, product_error(a, b, p));
  precise const float error = fma(a, b, -p);
  return Pair(p, error);
}
Pair plus(Pair a, Pair b) {  // 3 u^2 of the sum
  const Pair s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
#ifdef MUTANT_16
  precise const float c = s.low;
#else
  precise const float c = s.low + t.high;
#endif
  const Pair v = quick_two_sum(s.high, c);
  precise const float w = t.low + v.low;
  return quick_two_sum(v.high, w);
}
Pair negated(Pair a) { return Pair(-a.high, -a.low); }
Pair times(bool fused, Pair a, Pair b) {  // 7 u^2 of the product
  const Pair c = two_product(fused, a.high, b.high);
#ifdef MUTANT_17
  precise const float cross_terms = a.high * b.low;
#else
  precise const float cross_terms = a.high * b.low + a.low * b.high;
#endif
  precise const float low = c.low + cross_terms;
  return quick_two_sum(c.high, low);
}
Pair area_of(bool fused, Pair ax, Pair ay, Pair bx, Pair by) {
  return plus(times(fused, ax, by), negated(times(fused, bx, ay)));
}

Interpolated in_pairs(bool fused, Triangle t) {
  Pair x[3], y[3];
  for (uint k = 0u; k < 3u; ++k) {
    const vec3 v = t.corners[k];
    x[k] = plus(two_product(fused, t.half_extent.x, v.x), negated(two_product(fused, t.offset.x, v.z)));
    y[k] = plus(two_product(fused, t.half_extent.y, v.y), negated(two_product(fused, t.offset.y, v.z)));
  }
  Pair areas[3];
  for (uint k = 0u; k < 3u; ++k) {
    const uint a = (k + 1u) % 3u, b = (k + 2u) % 3u;
    areas[k] = area_of(fused, x[a], y[a], x[b], y[b]);
  }
  const Pair area = plus(plus(areas[0], areas[1]), areas[2]);
  return weigh(t, vec3(areas[0].high, areas[1].high, areas[2].high), area.high,
               vec4(plus(y[2], negated(y[0])).high, plus(y[0], negated(y[1])).high, plus(x[0], negated(x[2])).high,
                    plus(x[1], negated(x[0])).high));
}

Interpolated interpolate(Triangle t) {
  if (!rescale(t)) return degenerate();
  const bool fused = multiply_add_is_fused();
  vec3 x, y, areas;
  recentre(fused, t, x, y, areas);
  const float area = areas.x + areas.y + areas.z;
  const float magnitudes = dot(abs(x), abs(y.yzx) + abs(y.zxy));
#ifdef MUTANT_18
  if (magnitudes > 65536.0 * kWellConditioned * abs(area)) return in_pairs(fused, t);
#else
  if (!(magnitudes <= kWellConditioned * abs(area))) return in_pairs(fused, t);
#endif
  return weigh_recentred(t, x, y, areas, area);
}
