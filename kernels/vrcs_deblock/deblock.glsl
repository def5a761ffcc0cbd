// The deblocker. The includer says where radiance is read and stored, and which neighbours belong to a pixel:
//   uvec2 texel_at(ivec2 pixel); bool belongs(ivec2 pixel, ivec2 neighbour);
//   void store_texel(ivec2 pixel, uvec2 texel, bool changed);
// Loop turns of an invocation: 4 entries, 4 pixels twice, of these 4 with 2 sides each.
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
  ivec2 side = ivec2(kind != kCopyVertical, kind != kCopyHorizontal);
#ifdef MUTANT_11  // one diagonal of the two
  const uint sides = 1u;
#else
  const uint sides = kind == kCopyDiagonal ? 2u : 1u;
#endif
  for (uint i = 0u; i < sides; ++i, side.y = -side.y) add_pair(pixel, side, sum, pairs);
  return pairs == 0.0 ? copy : with_colour(copy, sum * (pairs == 1.0 ? 0.5 : 0.25));
}

void store(ivec2 pixel, uvec2 copy, uvec2 texel, bool changed) {
  if (pixel.x >= int(params.width) || pixel.y >= int(params.height)) return;
  store_texel(pixel, texel, changed);
#ifdef MUTANT_13  // the copy's luma
  store_luma(pixel, copy);
#else
  store_luma(pixel, texel);
#endif
}

// Duplicates one after the other, so that a cell takes as many turns as it has, and then all is stored.
void main() {
  const uint cell = gl_LocalInvocationIndex;
  const uint marked = marks_of_cell(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, cell);
  const ivec2 first = ivec2(gl_WorkGroupID.xy * kVrcsTileSide + uvec2(cell % 8u, cell / 8u) * kCellSide);
  const ivec2 last = ivec2(params.width, params.height) - 1;
  uvec2 copies[4], texels[4];
  uint changed = 0u;  // a bit a pixel
  for (uint i = 0u; i < 4u; ++i) {
    const ivec2 pixel = first + ivec2(i & 1u, i >> 1);
    copies[i] = texels[i] = texel_at(min(pixel, last));
    if (kind_of(marked, i) != 0u && on_screen(pixel)) changed |= 1u << i;
  }
  for (uint left = changed; left != 0u; left &= left - 1u) {
    const uint i = findLSB(left);
    const uvec2 copy = i < 2u ? (i == 0u ? copies[0] : copies[1]) : (i == 2u ? copies[2] : copies[3]);
    const uvec2 texel = deblocked(first + ivec2(i & 1u, i >> 1), kind_of(marked, i), copy);
    for (uint k = 0u; k < 4u; ++k) texels[k] = k == i ? texel : texels[k];
  }
  for (uint i = 0u; i < 4u; ++i)
    store(first + ivec2(i & 1u, i >> 1), copies[i], texels[i], (changed >> i & 1u) != 0u);
}
