// How large a rectangle a particle wants: reproducible to the bit. Only sums, products and comparisons of floats, which
// Vulkan rounds correctly, in an order that `precise` keeps; none of them overflows or is denormal where it matters
// (kernels/particle_rects/README.md).

bool is_number(float v) { return (floatBitsToUint(v) & 0x7f800000u) != 0x7f800000u; }
bool is_number(vec3 v) { return is_number(v.x) && is_number(v.y) && is_number(v.z); }

// Within `most`, and 0 where it is all but that, or no number.
float held(float v, float most) {
  if (!(abs(v) >= kLeastLength)) return 0.0;
  return v < 0.0 ? max(v, -most) : min(v, most);
}
vec3 held(vec3 v, float most) { return vec3(held(v.x, most), held(v.y, most), held(v.z, most)); }

float dot_in_order(vec3 a, vec3 b) {
  precise float sum = a.x * b.x;
  sum = sum + a.y * b.y;
  sum = sum + a.z * b.z;
  return sum;
}
vec3 cross_in_order(vec3 a, vec3 b) {
  precise float x = a.y * b.z - a.z * b.y;
  precise float y = a.z * b.x - a.x * b.z;
  precise float z = a.x * b.y - a.y * b.x;
  return vec3(x, y, z);
}

struct Quad {
  vec3 centre;
  vec3 right;
  vec3 up;
};

// How far the farthest point of the quad lies along a direction.
float farthest_along(vec3 direction, Quad q) {
  const vec3 d = held(direction, 1.0);
#ifdef MUTANT_1  // of the centre alone
  return dot_in_order(d, q.centre);
#else
  precise float sum = dot_in_order(d, q.centre) + abs(dot_in_order(d, q.right));
  sum = sum + abs(dot_in_order(d, q.up));
  return sum;
#endif
}

bool is_in_view(Quad q, float near) {
#ifdef MUTANT_2  // what is above the picture too
  if (farthest_along(params.left, q) < 0.0 || farthest_along(params.right, q) < 0.0) return false;
#else
  if (farthest_along(params.left, q) < 0.0 || farthest_along(params.right, q) < 0.0 ||
      farthest_along(params.top, q) < 0.0 || farthest_along(params.bottom, q) < 0.0)
    return false;
#endif
  return farthest_along(params.forward, q) > near;
}

// (side z)^4
float fourth_power(float side, float z) {
  precise float v = side * z;
  v = v * v;
  v = v * v;
  return v;
}

// Area on the screen: (4 |a x b| / z^2) of half axes a, b in pixels at distance 1. Squared, and compared times z^4.
uint size_of(Quad q, float scale, float z) {
  precise vec3 a = q.right * scale;
  precise vec3 b = q.up * scale;
  const vec3 across = cross_in_order(a, b);
  precise float area = 16.0 * dot_in_order(across, across);
  if (area < fourth_power(kLeastSide, z)) return 0u;
  if (area < fourth_power(kSideOf16, z)) return 1u;
#ifdef MUTANT_3  // at the boundary the smaller
  return area <= fourth_power(kSideOf32, z) ? 2u : 3u;
#else
  return area < fourth_power(kSideOf32, z) ? 2u : 3u;
#endif
}

uint wanted_size(ParticleRecord p) {
  if (!is_number(p.centre) || !is_number(p.right) || !is_number(p.up)) return 0u;
#ifdef MUTANT_4  // what cannot be seen is lit
  if (!is_number(p.opacity) || !is_number(p.quality) || !(p.quality >= kLeastShown)) return 0u;
#else
  if (!is_number(p.opacity) || !is_number(p.quality) || !(p.opacity >= kLeastShown) || !(p.quality >= kLeastShown))
    return 0u;
#endif
  const Quad q = Quad(held(p.centre, kMostDistance), held(p.right, kMostAxis), held(p.up, kMostAxis));
  const float near = max(held(params.near_plane, kMostDistance), kLeastDistance);
  if (!is_in_view(q, near)) return 0u;
  precise float scale = held(params.pixels, kMostPixels) * held(p.quality, kMostPixels);
  scale = held(scale, kMostPixels);
#ifdef MUTANT_5  // nearer than the near plane counts as there
  const float z = dot_in_order(held(params.forward, 1.0), q.centre);
#else
  const float z = max(dot_in_order(held(params.forward, 1.0), q.centre), near);
#endif
  return size_of(q, scale, z);
}
