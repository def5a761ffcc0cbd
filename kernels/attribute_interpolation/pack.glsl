// The three encodings of formats/attributes.h. Everything rounds to nearest by hand.
#include "harness/glsl/half.glsl"
layout(constant_id = 0) const uint LAYOUT = kAttributesPacked;

uint unorm16(float v) { return uint(TO_NEAREST(v * 65535.0)); }  // of 0..1
uint snorm16(float v) { return uint(int(TO_NEAREST(clamp(v, -1.0, 1.0) * 32767.0))) & 0xffffu; }

uint pack_barycentrics(vec3 weights) {
#ifdef MUTANT_20
  const vec2 stored = clamp(weights.xy, 0.0, 1.0);
#else
  const vec2 stored = clamp(weights.yz, 0.0, 1.0);
#endif
  if (LAYOUT == kAttributesHalves) return binary16(stored.x) | binary16(stored.y) << 16;
  return unorm16(stored.x) | unorm16(stored.y) << 16;
}

uvec2 pack_shared_exponent(vec4 d, uint flags) {
  const uint bits = max(magnitude_bits(d.xyz), floatBitsToUint(abs(d.w)));
  const uint exponent = min((bits >> 23) + 1u, 255u);
  if (exponent < 28u) return uvec2(0u, flags << 28);
  const float limit = float(kAttributeMantissaLimit);
  const ivec4 m = ivec4(clamp(TO_NEAREST(d * uintBitsToFloat((266u - exponent) << 23)), -limit, limit));
  const uvec4 mantissa = uvec4(m) & 0x1fffu;
  return uvec2(mantissa.x | mantissa.y << 13 | exponent << 26,
               mantissa.z | mantissa.w << 13 | (exponent >> 6) << 26 | flags << 28);
}

// A flag a number: as binary16's bit 14, which is 0 below 2, or in place of its lowest mantissa bit.
uint clamped_half(float d, uint flag) { return binary16(clamp(d, -1.9990234375, 1.9990234375)) | flag << 14; }
uint scaled_half(float d, uint flag) {
  const float v = d * kAttributeHalfScale;
  return (small_float(clamp(v, -65472.0, 65472.0), 9u) << 1) | flag;
}

uvec2 pack_derivatives(vec4 d, uint flags) {
#ifdef MUTANT_21
  d = d.xzyw;
#endif
  if (LAYOUT == kAttributesPacked) return pack_shared_exponent(d, flags);
  const uvec4 f = uvec4(flags, flags >> 1, flags >> 2, flags >> 3) & 1u;
  if (LAYOUT == kAttributesHalfScaled)
    return uvec2(scaled_half(d.x, f.x) | scaled_half(d.y, f.y) << 16,
                 scaled_half(d.z, f.z) | scaled_half(d.w, f.w) << 16);
  return uvec2(clamped_half(d.x, f.x) | clamped_half(d.y, f.y) << 16,
               clamped_half(d.z, f.z) | clamped_half(d.w, f.w) << 16);
}

uint pack_direction(vec3 n) {
  if (LAYOUT == kAttributesHalves) return binary16(n.x) | binary16(n.y) << 16;
  const vec2 e = n.xy * inversesqrt(1.0 + abs(n.z));
  return snorm16(e.x) | snorm16(e.y) << 16;
}

uint flags_of(Interpolated i, bool flipped, TangentFrame f) {
#ifdef MUTANT_22
  const bool front = !i.clockwise;
#else
  const bool front = i.clockwise == flipped;
#endif
#ifdef MUTANT_23
  const bool normal_negative = f.normal.z <= 0.0;
#else
  const bool normal_negative = f.normal.z < 0.0;
#endif
#ifdef MUTANT_9
  const bool left_handed = f.left_handed;
#else
  const bool left_handed = f.left_handed != flipped;
#endif
  return (front ? kAttributeFrontFacing : 0u) | (normal_negative ? kAttributeNormalNegative : 0u) |
         (f.tangent.z < 0.0 ? kAttributeTangentNegative : 0u) | (left_handed ? kAttributeLeftHanded : 0u);
}
