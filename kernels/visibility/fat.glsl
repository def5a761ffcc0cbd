// The second 64 bits of a fat texel; layout.h has the encoding.
#ifndef VISIBILITY_FAT
#define VISIBILITY_FAT
layout(location = 1) flat in uint material_and_hand;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec3 normal;
layout(location = 4) in vec3 tangent;
layout(location = 1) out uvec2 fat;

// A sign over an exponent and two bits of mantissa, rounded to nearest: the float's own leading bits.
uint pack_derivative(float d) {
  uint leading = (floatBitsToUint(abs(d)) + 0x100000u) >> 21;
  int code = clamp(int(leading) - (127 + kFatLowestExponent) * 4 + 1, 0, int(kFatCodes));
  return uint(code) | (d < 0 ? 0x80u : 0u);
}

// The octahedron of |x| + |y| + |z| = 1, its lower half folded outwards.
vec2 sign_or_one(vec2 v) { return vec2(v.x < 0 ? -1 : 1, v.y < 0 ? -1 : 1); }
uvec2 octahedral(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 p = n.z < 0 ? (1 - abs(n.yx)) * sign_or_one(n.xy) : n.xy;
  return uvec2(round(clamp(p, -1, 1) * kFatNormalSteps) + kFatNormalSteps);
}
vec3 from_octahedral(uvec2 code) {
  // In steps, which are whole numbers: z has a certain sign, and with it the basis below.
  vec2 p = vec2(code) - kFatNormalSteps;
  vec3 n = vec3(p, kFatNormalSteps - abs(p.x) - abs(p.y));
  if (n.z < 0) n.xy = (kFatNormalSteps - abs(n.yx)) * sign_or_one(n.xy);
  return normalize(n);
}

// Duff et al. 2017, Building an Orthonormal Basis, Revisited.
void basis(vec3 n, out vec3 b1, out vec3 b2) {
  float s = n.z < 0 ? -1 : 1;
  float a = -1 / (s + n.z);
  float b = n.x * n.y * a;
  b1 = vec3(1 + s * n.x * n.x * a, s * b, -s * n.x);
  b2 = vec3(b, s + n.y * n.y * a, -n.y);
}

uvec2 fat_texel() {
#ifdef MUTANT_14
  vec2 d_dx = dFdy(uv), d_dy = dFdx(uv);
#else
  vec2 d_dx = dFdx(uv), d_dy = dFdy(uv);
#endif
  uint derivatives = pack_derivative(d_dx.x) | pack_derivative(d_dx.y) << 8 | pack_derivative(d_dy.x) << 16 |
                     pack_derivative(d_dy.y) << 24;
  uvec2 n = octahedral(normal);
  vec3 b1, b2;
  basis(from_octahedral(n), b1, b2);
  float turns = atan(dot(tangent, b2), dot(tangent, b1)) / 6.283185307;
  uint angle = uint(int(round(turns * kFatTurnSteps)) & int(kFatTurnSteps - 1));
#ifdef MUTANT_15
  uint hand = 0u;
#else
  uint hand = material_and_hand & kNegativeHand;
#endif
  return uvec2(derivatives, n.x | n.y << 11 | angle << 22 | hand);
}
#endif
