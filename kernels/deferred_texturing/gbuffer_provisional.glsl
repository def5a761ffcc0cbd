#ifndef PROVISIONAL_GBUFFER
#define PROVISIONAL_GBUFFER
#include "harness/formats/gbuffer.h"
vec4 encode_base_roughness(vec3 base, float roughness) {
  return vec4(sqrt(clamp(base, 0.0, 1.0)), clamp(roughness, kMinimumRoughness, 1.0));
}
vec2 encode_normal(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  return n.z < 0.0 ? (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0) : n.xy;
}
uint encode_emissive(vec3 c) {
  c = clamp(c, 0.0, 65408.0);
  float largest = max(max(c.x, c.y), max(c.z, 1.52587890625e-05));
  int e = clamp(int(floatBitsToUint(largest) >> 23) - 126 + 15, 0, 31);
  float scale = uintBitsToFloat(uint(127 + 9 + 15 - e) << 23);
  if (uint(largest * scale + 0.5) == 512u) { e += 1; scale *= 0.5; }
  uvec3 m = uvec3(c * scale + 0.5);
  return m.x | m.y << 9 | m.z << 18 | uint(e) << 27;
}
#endif
