// The deblocker. The includer says where radiance is read and stored, and which neighbours belong to a pixel:
//   uvec2 texel_at(ivec2 pixel); bool belongs(ivec2 pixel, ivec2 neighbour);
//   void store_texel(ivec2 pixel, uvec2 texel, bool changed);
// Loop turns of an invocation: at most 765, in the tone curve.
#include "kernels/vrcs_deblock/duplicates.glsl"
#include "kernels/vrcs_deblock/halves.glsl"
#include "kernels/vrcs_deblock/luma.glsl"
#include "kernels/vrcs_deblock/nearest_halves.glsl"

uvec2 texel_at(ivec2 pixel);
bool belongs(ivec2 pixel, ivec2 neighbour);
void store_texel(ivec2 pixel, uvec2 texel, bool changed);

// Adds two neighbours on opposite sides, both or neither: their mean is where the pixel is, one alone is beside it.
void add_pair(ivec2 pixel, ivec2 side, inout vec3 sum, inout float pairs) {
  const ivec2 a = pixel - side, b = pixel + side;
  if (!on_screen(a) || !on_screen(b) || !belongs(pixel, a) || !belongs(pixel, b)) return;
  const uvec2 texel_a = texel_at(a), texel_b = texel_at(b);
#ifndef MUTANT_10  // NaN spreads
  if (!is_finite(texel_a) || !is_finite(texel_b)) return;
#endif
  precise const vec3 pair = colour_of(texel_a) + colour_of(texel_b);
  precise const vec3 all = sum + pair;
  sum = all;
  pairs += 1.0;
}

// A duplicate's mean of its neighbours; its copy where no pair of them counts.
uvec2 deblocked(ivec2 pixel, uint kind, uvec2 copy) {
  if (!is_finite(copy)) return copy;
  vec3 sum = vec3(0.0);
  float pairs = 0.0;
  add_pair(pixel, ivec2(kind != kCopyVertical, kind != kCopyHorizontal), sum, pairs);
#ifndef MUTANT_11  // one diagonal of the two
  if (kind == kCopyDiagonal) add_pair(pixel, ivec2(1, -1), sum, pairs);
#endif
  return pairs == 0.0 ? copy : with_colour(copy, sum * (pairs == 1.0 ? 0.5 : 0.25));
}

void main() {
  const uint i = gl_LocalInvocationIndex;
  const uint kind = kind_of(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, i);
  const ivec2 pixel = ivec2(gl_WorkGroupID.xy * kVrcsTileSide + uvec2(i % kVrcsTileSide, i / kVrcsTileSide));
  if (pixel.x >= int(params.width) || pixel.y >= int(params.height)) return;
  const uvec2 copy = texel_at(pixel);
  const uvec2 texel = kind == 0u ? copy : deblocked(pixel, kind, copy);
  store_texel(pixel, texel, kind != 0u);
#ifdef MUTANT_13  // the copy's luma
  imageStore(luma, pixel, vec4(luma_of(copy)));
#else
  imageStore(luma, pixel, vec4(luma_of(texel)));
#endif
}
