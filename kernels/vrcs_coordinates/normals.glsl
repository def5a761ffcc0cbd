// Directions as whole numbers of at most 15 bits and a sign, whose squared lengths are below 2^30; zero is none.
#include "kernels/vrcs_coordinates/depths.glsl"

int dot_of(ivec3 a, ivec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// The squared sine is 1 - (a.b)^2 / (|a|^2 |b|^2), in products of 64 bits.
bool close_normals(ivec3 a, ivec3 b) {
  const int along = dot_of(a, b);
#ifdef MUTANT_15  // back to back is as good as side by side
  if (along == 0) return false;
#else
  if (along <= 0) return false;
#endif
  uint whole_high, whole, cosine_high, cosine, borrow;
  umulExtended(uint(dot_of(a, a)), uint(dot_of(b, b)), whole_high, whole);
  umulExtended(uint(abs(along)), uint(abs(along)), cosine_high, cosine);
  const uint sine = usubBorrow(whole, cosine, borrow), sine_high = whole_high - cosine_high - borrow;
  const uint n = min(params.close_normals_log2, 31u);
  const uint limit = n == 0u ? whole : whole >> n | whole_high << 32u - n, limit_high = whole_high >> n;
  return sine_high < limit_high || (sine_high == limit_high && sine <= limit);
}
