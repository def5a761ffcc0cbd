// The G-buffer of harness/formats/gbuffer.h, written and read. Before including, a writer defines GBUFFER_WRITES and a
// reader GBUFFER_READS as the first of the four bindings of its images; `features` is a buffer that each declares
// itself. The encodings can be had without either.
#ifndef HARNESS_GLSL_GBUFFER
#define HARNESS_GLSL_GBUFFER
#include "harness/formats/gbuffer.h"
#include "harness/glsl/ports.glsl"

// What the images hold of a pixel, decoded. A pixel without a surface is all zero, normal and all.
struct GBufferTexel {
  vec3 base_colour;  // linear, 0..1
  float roughness;   // perceptual, 0..1
  vec3 normal;       // world, unit
  float metallic;    // 0..1
  float occlusion;   // 0..1, 1 is open
  vec3 emissive;     // radiance, 0..65408
};

// Into 0..1; NaN is 0.
float saturated(float v) { return v > 0.0 ? min(v, 1.0) : 0.0; }
vec3 saturated(vec3 v) { return vec3(saturated(v.x), saturated(v.y), saturated(v.z)); }

// The octahedron |x| + |y| + |z| = 1 seen from above, its lower half folded outwards (Cigolle et al. 2014). A vector
// without a direction (zero, NaN, infinite) becomes (0, 0), which is +z.
vec2 sign_or_one(vec2 v) { return vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0); }
vec2 encode_octahedral(vec3 n) {
  const float sum = abs(n.x) + abs(n.y) + abs(n.z);
  if (!(sum > 0.0 && sum <= 3.402823466e38)) return vec2(0.0);
  const vec3 o = n / sum;
#ifdef MUTANT_9301  // the lower half is not folded
  return o.xy;
#else
  return o.z < 0.0 ? (1.0 - abs(o.yx)) * sign_or_one(o.xy) : o.xy;
#endif
}

// From what a texel of RG16_SNORM reads as. Its codes are whole numbers once scaled back, whichever way the device
// rounds c / 32767, so all is exact up to the final normalisation.
vec3 decode_octahedral(vec2 code) {
  const float steps = 32767.0;
  const vec2 p = round(code * steps);
  vec3 n = vec3(p, steps - abs(p.x) - abs(p.y));
#ifndef MUTANT_9302  // the lower half stays folded
  if (n.z < 0.0) n.xy = (steps - abs(p.yx)) * sign_or_one(p);
#endif
  return n * inversesqrt(dot(n, n));
}

// E5B9G9R9 as Vulkan defines it: three mantissas of 9 bits, red lowest, under one exponent of bias 15. Negative and NaN
// are 0, more than 65408 is 65408. Halves round up; nothing else is rounded: all scales are powers of two.
uint encode_shared_exponent(vec3 radiance) {
  const vec3 c = vec3(radiance.r > 0.0 ? min(radiance.r, 65408.0) : 0.0, radiance.g > 0.0 ? min(radiance.g, 65408.0) : 0.0,
                      radiance.b > 0.0 ? min(radiance.b, 65408.0) : 0.0);
  const int floor_log2 = int(floatBitsToUint(max(c.r, max(c.g, c.b))) >> 23) - 127;
  int exponent = max(floor_log2, -16) + 16;
  vec3 scaled = c * uintBitsToFloat(uint(127 + 24 - exponent) << 23);
  if (max(scaled.r, max(scaled.g, scaled.b)) >= 511.5) {  // would round to 512
    ++exponent;
    scaled *= 0.5;
  }
  // Not floor(scaled + 0.5), whose sum is rounded.
  const vec3 whole = floor(scaled);
#ifdef MUTANT_9303  // truncated
  const uvec3 m = uvec3(whole);
#else
  const uvec3 m = uvec3(whole) + uvec3(greaterThanEqual(scaled - whole, vec3(0.5)));
#endif
  return uint(exponent) << 27 | m.b << 18 | m.g << 9 | m.r;
}
vec3 decode_shared_exponent(uint code) {
  const uvec3 m = uvec3(code, code >> 9, code >> 18) & 511u;
#ifdef MUTANT_9304  // the exponent's bias is off by one
  return vec3(m) * uintBitsToFloat((127u - 23u + (code >> 27)) << 23);
#else
  return vec3(m) * uintBitsToFloat((127u - 24u + (code >> 27)) << 23);
#endif
}

// Eight bits hold a colour's square root: as fine in the dark as sRGB nearly is, and one product to undo.
vec4 encode_base_roughness(vec3 base_colour, float roughness) {
#ifdef MUTANT_9305  // linear colour
  return vec4(saturated(base_colour), saturated(roughness));
#else
  return vec4(sqrt(saturated(base_colour)), saturated(roughness));
#endif
}
vec3 decode_base_colour(vec4 code) {
#ifdef MUTANT_9306  // taken for linear
  return code.rgb;
#else
  return code.rgb * code.rgb;
#endif
}

#ifdef GBUFFER_WRITES
layout(binding = GBUFFER_WRITES, rgba8) uniform writeonly restrict image2D base_roughness;
layout(binding = GBUFFER_WRITES + 1, rg16_snorm) uniform writeonly restrict image2D normal;
layout(binding = GBUFFER_WRITES + 2, rg8) uniform writeonly restrict image2D metallic_occlusion;
layout(binding = GBUFFER_WRITES + 3, r32ui) uniform writeonly restrict uimage2D emissive;

void store_gbuffer(uvec2 pixel, GBufferTexel t) {
  const ivec2 at = ivec2(pixel);
  imageStore(base_roughness, at, encode_base_roughness(t.base_colour, t.roughness));
  imageStore(normal, at, vec4(encode_octahedral(t.normal), 0.0, 0.0));
  imageStore(metallic_occlusion, at, vec4(saturated(t.metallic), saturated(t.occlusion), 0.0, 0.0));
  imageStore(emissive, at, uvec4(encode_shared_exponent(t.emissive), 0u, 0u, 0u));
}
void store_no_surface(uvec2 pixel) {
  store_gbuffer(pixel, GBufferTexel(vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, vec3(0.0)));
}
#endif

#ifdef GBUFFER_READS
layout(binding = GBUFFER_READS) uniform texture2D base_roughness;
layout(binding = GBUFFER_READS + 1) uniform texture2D normal;
layout(binding = GBUFFER_READS + 2) uniform texture2D metallic_occlusion;
layout(binding = GBUFFER_READS + 3) uniform utexture2D emissive;

// The normal of a pixel without a surface is +z; whether there is one is asked of the depth.
GBufferTexel load_gbuffer(uvec2 pixel) {
  const ivec2 at = ivec2(pixel);
  const vec4 base = texelFetch(base_roughness, at, 0);
  const vec2 metal = texelFetch(metallic_occlusion, at, 0).rg;
  return GBufferTexel(decode_base_colour(base), base.a, decode_octahedral(texelFetch(normal, at, 0).rg), metal.r,
                      metal.g, decode_shared_exponent(texelFetch(emissive, at, 0).r));
}
#endif
#endif
