// A thread a cell of 2x2 pixels, a group 8x8 of them. TILE, 2 or 8: the pixels a side that get one rate. Of them, the
// squared differences of luma, in its codes: integers, so that only the threshold is rounded.
// A picture's sides mirror: what lies beyond the outermost pixel is the one before it.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_shading_rate/layout.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform texture2D luma;
layout(binding = 1, r8ui) uniform restrict writeonly uimage2D rates;
PARAMS(RateParams);

const uint kSide = 18u;  // 16 pixels and a ring
shared uint codes[kSide * kSide];  // opaque in bits 0..7, with blended surfaces above

ivec2 mirrored(ivec2 at) {
  const ivec2 last = ivec2(params.width, params.height) - 1;
#ifdef MUTANT_1  // the outermost pixel goes on
  return clamp(at, ivec2(0), last);
#else
  return clamp(last - abs(last - abs(at)), ivec2(0), last);
#endif
}
void load_codes() {
  const ivec2 corner = ivec2(gl_WorkGroupID.xy * 16u) - 1;
  for (uint i = gl_LocalInvocationIndex; i < kSide * kSide; i += 64u) {
    const vec2 l = texelFetch(luma, mirrored(corner + ivec2(i % kSide, i / kSide)), 0).xy;
    const uvec2 code = uvec2(l * 255.0 + 0.5);
    codes[i] = code.x | code.y << 8u;
  }
}

// What an estimator says of a window: squared errors across, down, and diagonally, which 2x2 has beside the others.
struct Sums {
  uint luma;
  uvec3 first;
  uvec3 second;
};
Sums nothing() { return Sums(0u, uvec3(0u), uvec3(0u)); }

#ifdef SOBEL
const bool kIsMaximum = true;
#else
const bool kIsMaximum = false;
#endif
Sums joined(Sums a, Sums b) {
  if (kIsMaximum) return Sums(a.luma + b.luma, max(a.first, b.first), a.second);
  return Sums(a.luma + b.luma, a.first + b.first, a.second + b.second);
}

// `at`: in `codes`; `shift`: of the luma in it.
int code_at(ivec2 at, uint shift) { return int(codes[at.y * int(kSide) + at.x] >> shift & 0xffu); }
uint squared(int v) { return uint(v * v); }

Sums sums_of_pixel(ivec2 at, uint shift) {
  const int here = code_at(at, shift);
  Sums s = nothing();
  s.luma = uint(here);
  const int left = code_at(at - ivec2(1, 0), shift), right = code_at(at + ivec2(1, 0), shift);
  const int up = code_at(at - ivec2(0, 1), shift), down = code_at(at + ivec2(0, 1), shift);
  const int up_left = code_at(at - 1, shift), up_right = code_at(at + ivec2(1, -1), shift);
  const int down_left = code_at(at + ivec2(-1, 1), shift), down_right = code_at(at + 1, shift);
#ifdef SOBEL
  const int across = up_right + 2 * right + down_right - up_left - 2 * left - down_left;
  const int along = down_left + 2 * down + down_right - up_left - 2 * up - up_right;
  s.first = uvec3(squared(across), squared(along), 0u);
#endif
#if defined(FIRST) || defined(SLOPE)
#ifdef MUTANT_2  // the neighbours on the right of pixels on the left alone: blind to one phase
  s.first = (at.x & 1) == 0 ? uvec3(0u) : uvec3(squared(right - here), squared(down - here), squared(down_right - here));
#else
  s.first = uvec3(squared(right - here), squared(down - here), squared(down_right - here));
#endif
#endif
#if !defined(SOBEL) && !defined(FIRST)
  s.second = uvec3(squared(left - 2 * here + right), squared(up - 2 * here + down),
                   squared(4 * here - up_left - up_right - down_left - down_right));
#endif
  return s;
}

uvec2 picture() { return uvec2(params.width, params.height); }

// Of the cell's pixels that the picture has.
Sums sums_of_cell(uint shift) {
  Sums s = nothing();
  for (uint i = 0u; i < 4u; ++i) {
    const uvec2 in_group = gl_LocalInvocationID.xy * 2u + uvec2(i & 1u, i >> 1u);
#ifndef MUTANT_3  // pixels beyond the sides count
    if (any(greaterThanEqual(gl_WorkGroupID.xy * 16u + in_group, picture()))) continue;
#endif
    s = joined(s, sums_of_pixel(ivec2(in_group + 1u), shift));
  }
  return s;
}

#if TILE == 8
shared Sums cell_sums[2][64];

// Of all cells of the thread's tile, in their order.
Sums sums_of_tile(uint which) {
  const uvec2 first = gl_LocalInvocationID.xy & 4u;
  Sums s = nothing();
#ifdef MUTANT_7  // the last cell is left out
  const uint cells = 15u;
#else
  const uint cells = 16u;
#endif
  for (uint i = 0u; i < cells; ++i) s = joined(s, cell_sums[which][(first.y + i / 4u) * 8u + first.x + i % 4u]);
  return s;
}
#endif

// Squared errors of the three rates, in codes and over the window, `kScale` times too large: 2x1, 1x2, 2x2.
uvec3 errors_of(Sums s) {
#if defined(SOBEL)
  return uvec3(s.first.xy, max(s.first.x, s.first.y));
#elif defined(FIRST)
  return uvec3(s.first.xy, s.first.x + s.first.y + s.first.z);
#else
  const uvec3 bent = uvec3(16u * s.second.xy, 16u * (s.second.x + s.second.y) + 4u * s.second.z);
#ifdef SLOPE
  return max(bent, uvec3(s.first.xy, s.first.x + s.first.y + s.first.z));
#else
  return bent;
#endif
#endif
}
#ifdef FIRST
const float kScale = 1.0;
#else
const float kScale = 64.0;
#endif

// How much of the tolerance holds in the tile.
float gain_of_place(uvec2 tile) {
  const uvec2 middle = tile * TILE + TILE / 2;
  float gain = 1.0;
  if (params.foveation != 0.0) {
    const vec2 off = vec2(2u * middle) / vec2(picture()) - 1.0;
    gain += params.foveation * 0.5 * dot(off, off);
  }
  const uvec2 near = min(middle, max(picture(), middle) - middle);
#ifdef MUTANT_4  // the border is the middle
  if (min(near.x, near.y) >= params.border) gain *= params.border_gain;
#else
  if (min(near.x, near.y) < params.border) gain *= params.border_gain;
#endif
  return gain;
}

// The coarsest rate whose error passes `most`; of both half rates the one with the lesser error.
uint half_rate(uvec3 errors, bvec2 passes) {
  if (passes.x && passes.y) return errors.x <= errors.y ? kRate2x1 : kRate1x2;
  return passes.x ? kRate2x1 : passes.y ? kRate1x2 : kRate1x1;
}
uint rate_within(uvec3 errors, float most) {
#ifdef MUTANT_5  // motion is forgotten
  if (float(errors.z) <= most) return kRate2x2;
#else
  if (float(errors.z) * params.quarter_weight <= most) return kRate2x2;
#endif
  return half_rate(errors, lessThanEqual(vec2(errors.xy) * params.half_weight, vec2(most)));
}

uint rate_of(Sums s, uint pixels, float tolerance) {
  const float base = (params.flags & kWeber) != 0u ? float(s.luma) / float(pixels) + params.ambient * 255.0 : 255.0;
  const float passes = tolerance * base, of_window = kIsMaximum ? kScale : kScale * float(pixels);
  const uvec3 errors = errors_of(s);
  const uint rate = rate_within(errors, passes * passes * of_window);
  if (rate != kRate2x2 || !(params.extra_half > 0.0 && params.extra_half < 1.0)) return rate;
  const float less = passes * params.extra_half;
  const uint again = rate_within(errors, less * less * of_window);
#ifdef MUTANT_6  // 1x1 is allowed then
  return again;
#else
  return again == kRate1x1 ? half_rate(errors, bvec2(true)) : again;
#endif
}

uint shared_pixels(uint rate) { return (1u << (rate >> 2u)) << (rate & 3u); }

void main() {
  load_codes();
  barrier();
  Sums sums[2];
  for (uint i = 0u; i < 2u; ++i) sums[i] = sums_of_cell(8u * i);
#if TILE == 8
  for (uint i = 0u; i < 2u; ++i) cell_sums[i][gl_LocalInvocationIndex] = sums[i];
  barrier();
  for (uint i = 0u; i < 2u; ++i) sums[i] = sums_of_tile(i);
#endif
  const uvec2 cell = gl_GlobalInvocationID.xy, tile = cell / (TILE / 2);
  if (any(greaterThanEqual(cell * 2u, picture()))) return;
  const uvec2 inside = min(picture() - tile * TILE, uvec2(TILE));
  const float tolerance = params.tolerance * gain_of_place(tile);
  const uint opaque = rate_of(sums[0], inside.x * inside.y, tolerance),
             blended = rate_of(sums[1], inside.x * inside.y, tolerance);
#ifdef MUTANT_8  // blended surfaces refine
  uint rate = shared_pixels(blended) < shared_pixels(opaque) ? blended : opaque;
#else
  uint rate = shared_pixels(blended) > shared_pixels(opaque) ? blended : opaque;
#endif
  if ((params.flags & kAllFull) != 0u) rate = kRate1x1;
  imageStore(rates, ivec2(cell), uvec4(rate));
}
