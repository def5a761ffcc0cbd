// What every variant binds, which triangle a pixel shows, and where its corners are.
#include "harness/glsl/ports.glsl"
#include "kernels/attribute_interpolation/layout.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform utexture2D visibility;
READS(1, vec3, positions);
READS(2, VertexAttributes, attributes);
READS(3, uint, indices);
READS(4, SurfaceRecord, surfaces);
READS(5, ClipSample, clip_samples);
PARAMS(AttributeParams);

struct Triangle {
  vec3 corners[3];   // clip x, y, w
  vec2 half_extent;  // of the viewport, pixels
  vec2 offset;       // of the pixel's centre from the viewport's; exact below 2^23 pixels
  bool has_attributes;
  bool flipped;  // the transform mirrors
  uint surface;
  uvec3 vertices;
};

struct Interpolated {
  vec3 weights;
  vec4 derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  bool clockwise;    // on the screen, y down
};
Interpolated degenerate() { return Interpolated(vec3(1.0 / 3.0), vec4(0), false); }

uint clamped(uint i, uint count) { return min(i, count - 1u); }

// One of the clip rows, in the order and with the roundings of the visibility draw: coverage and weights then speak of
// the same triangle, to the bit.
float along(vec4 row, vec3 p) {
#ifdef MUTANT_1
  precise float sum = row.x * p.x + row.y * p.y + row.z * p.z;
#else
  precise float sum = row.x * p.x + row.y * p.y + row.z * p.z + row.w;
#endif
  return sum;
}

void place(inout Triangle t, uvec2 pixel, uvec2 viewport) {
  t.half_extent = 0.5 * vec2(viewport);
#ifdef MUTANT_2
  t.offset = vec2(pixel) - t.half_extent;
#else
  t.offset = vec2(pixel) + 0.5 - t.half_extent;
#endif
}

bool clip_sample_at(uvec2 pixel, inout Triangle t) {
  const uint i = pixel.y * params.width + pixel.x;
  if (i >= params.clip_samples) return false;
  const ClipSample s = clip_samples[i];
  t.corners = vec3[3](s.v0, s.v1, s.v2);
  place(t, s.pixel, s.viewport);
  t.has_attributes = false;
  t.flipped = false;
  return true;
}

bool triangle_at(uvec2 pixel, out Triangle t) {
  if (params.clip_samples > 0u) return clip_sample_at(pixel, t);
  const uvec2 shown = texelFetch(visibility, ivec2(pixel), 0).xy;
#ifdef MUTANT_3
  if (shown.y == kVisibilityNone) return false;
#else
  if (shown == uvec2(kVisibilityNone)) return false;
#endif
  if (params.surfaces == 0u || params.indices == 0u || params.vertices == 0u) return false;
#ifdef MUTANT_4
  t.surface = clamped(shown.y & ~kVisibilityFlipped, params.surfaces);
#else
  t.surface = clamped(shown.y & kVisibilitySurfaceMask, params.surfaces);
#endif
  const SurfaceRecord s = surfaces[t.surface];
  for (uint k = 0u; k < 3u; ++k) {
    const uint index = indices[clamped(s.first_index + 3u * shown.x + k, params.indices)];
#ifdef MUTANT_5
    t.vertices[k] = clamped(index, params.vertices);
#else
    t.vertices[k] = clamped(index + s.vertex_offset, params.vertices);
#endif
    const vec3 p = positions[t.vertices[k]];
    t.corners[k] = vec3(along(s.clip_x, p), along(s.clip_y, p), along(s.clip_w, p));
  }
  place(t, pixel, uvec2(params.width, params.height));
  t.has_attributes = true;
  t.flipped = (shown.y & kVisibilityFlipped) != 0u;
  return true;
}

uint magnitude_bits(vec3 v) {
  const uvec3 bits = floatBitsToUint(v) & 0x7fffffffu;
  return max(max(bits.x, bits.y), bits.z);
}
// 2^-e for a number of magnitude bits in 2^e .. 2^(e+1); false for what is too small, too large, infinite or NaN.
bool scale_for(uint bits, out float scale) {
  const uint exponent = bits >> 23;
  scale = uintBitsToFloat((254u - exponent) << 23);
  return exponent >= kSmallestExponent && exponent <= kLargestExponent;
}
