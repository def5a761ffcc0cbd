// Weights do not change when all coordinates are scaled. By a power of two, that is exact, and products of coordinates of
// 10^18 no longer overflow. False where the largest is too small, too large, infinite or NaN.
#ifndef HARNESS_GLSL_INTERPOLATION_RESCALE
#define HARNESS_GLSL_INTERPOLATION_RESCALE
#include "harness/glsl/interpolation/triangle.glsl"
bool rescale(inout Triangle t) {
  float scale;
  const uint largest =
      max(max(magnitude_bits(t.corners[0]), magnitude_bits(t.corners[1])), magnitude_bits(t.corners[2]));
  if (!scale_for(largest, scale)) return false;
#ifndef MUTANT_9105  // coordinates are not scaled
  for (uint k = 0u; k < 3u; ++k) t.corners[k] *= scale;
#endif
  return true;
}
#endif
