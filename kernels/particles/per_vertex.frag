#version 460
// The end of the scale that costs least: lit at the corners, linear over either triangle as the hardware would have it.
#include "kernels/particles/fragment.glsl"
READS(6, vec3, corners);

vec3 light_at(Place p) {
  const uint first = entry_particle.x * kCorners;
  const vec2 t = p.at * 0.5 + 0.5;
  const vec3 low = corners[first], high = corners[first + 2u];
#ifdef MUTANT_17  // the other diagonal
  const uint third = t.x <= t.y ? 1u : 3u;
#else
  const uint third = t.x >= t.y ? 1u : 3u;
#endif
  const float far = min(t.x, t.y), near = max(t.x, t.y);
  return low * (1.0 - near) + corners[first + third] * (near - far) + high * far;
}
