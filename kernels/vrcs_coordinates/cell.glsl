// A cell of 2x2 pixels: what its pixels show, which of them are shaded, and which copy those.
// Pixels of a cell are numbered in rows, so that the numbers of two differ in bit 0 where they lie side by side, in bit
// 1 one below the other, in both across the diagonal.
// Loop turns of an invocation: 4 pixels, 3 others of each.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_coordinates/layout.h"
#include "harness/glsl/tiles.glsl"

layout(binding = 0) uniform utexture2D rates;
layout(binding = 1) uniform utexture2D visibility;
layout(binding = 2) uniform texture2D depth;
PARAMS(VrcsParams);

struct Cell {
  uvec2 first;    // its upper left pixel
  uvec2 seen[4];  // visibility
  uint depth[4];  // bits
  uint covered;   // a bit a pixel: it lies on the screen and has a surface
};

uvec2 extent() { return uvec2(params.width, params.height); }
uvec2 offset_of(uint pixel) { return uvec2(pixel & 1u, pixel >> 1u); }

// Bits of floats that are not negative are in the order of the floats. What is no positive normal number is 0: as far as
// can be.
uint bits_of_depth(float d) {
  const uint bits = floatBitsToUint(d);
  return bits >= 0x00800000u && bits < 0x7f800000u ? bits : 0u;
}
uint depth_bits(uvec2 pixel) { return bits_of_depth(texelFetch(depth, ivec2(pixel), 0).r); }

Cell cell_at(uvec2 first) {
  Cell cell;
  cell.first = first;
  cell.covered = 0u;
  for (uint i = 0u; i < 4u; ++i) {
    const uvec2 pixel = first + offset_of(i);
    cell.seen[i] = uvec2(kVisibilityNone);
    cell.depth[i] = 0u;
#ifdef MUTANT_1  // of the last column or row, the pixels beyond count
    if (!on_screen(first, extent())) continue;
#else
    if (!on_screen(pixel, extent())) continue;
#endif
    cell.seen[i] = texelFetch(visibility, ivec2(pixel), 0).xy;
    cell.depth[i] = depth_bits(pixel);
#ifdef MUTANT_2  // a triangle of all ones is taken for nothing
    if (cell.seen[i].x != kVisibilityNone) cell.covered |= 1u << i;
#else
    if (cell.seen[i] != uvec2(kVisibilityNone)) cell.covered |= 1u << i;
#endif
  }
  return cell;
}

uint rate_of(Cell cell) {
#ifndef MUTANT_3  // the rates of another frame, camera or resolution
  if (params.all_1x1 != 0u) return kRate1x1;
#endif
  return texelFetch(rates, ivec2(cell.first / kCellSide), 0).x;
}

// Which pixels may share at all: bit k where their numbers differ by k in the sense of XOR.
uint partners_at(uint rate) {
  if (rate == kRate2x1) return 1u << 1u;
  if (rate == kRate1x2) return 1u << 2u;
#ifdef MUTANT_4  // what is coarser than any known rate is the coarsest
  return rate >= kRate2x2 ? 0xeu : 0u;
#else
  return rate == kRate2x2 ? 0xeu : 0u;
#endif
}

// Pixels of different triangles that may share nevertheless.
#if defined(SAME_SURFACE)
#include "kernels/vrcs_coordinates/same_surface.glsl"
#elif defined(STORED_NORMAL)
#include "kernels/vrcs_coordinates/stored_normal.glsl"
#elif defined(REBUILT_NORMAL)
#include "kernels/vrcs_coordinates/rebuilt_normal.glsl"
#else
void prepare_sharing(uint tile) {}
bool shares_across(Cell cell, uint a, uint b) { return false; }
#endif

bool shares(Cell cell, uint a, uint b) {
#ifdef MUTANT_5  // whatever the surface
  return cell.seen[a].x == cell.seen[b].x || shares_across(cell, a, b);
#else
  return cell.seen[a] == cell.seen[b] || shares_across(cell, a, b);
#endif
}

// Which of a group's pixels is shaded. Of two side by side, or one below the other, that on the screen's checkerboard of
// this frame; cells begin at even coordinates, so it is a matter of the number. Of four the upper left and the lower
// right in turn, and so of two across. Of three one after the other, there and back.
uint primary_of(uint members) {
  const uint first = findLSB(members), last = findMSB(members);
  const bool odd = (params.frame & 1u) != 0u;
  const uint size = bitCount(members);
  if (size == 3u) {
    const uint rest = members & members - 1u;
#ifdef MUTANT_6  // there, and from the first again
    const uint step = params.frame % 3u;
#else
    const uint step = (params.frame & 3u) == 3u ? 1u : params.frame & 3u;
#endif
    return step == 0u ? first : findLSB(step == 1u ? rest : rest & rest - 1u);
  }
#ifdef MUTANT_7  // all pairs of a frame alike: no checkerboard
  return odd ? last : first;
#else
  const bool side_by_side = size == 2u && (first ^ last) != 3u;
  return odd != (side_by_side && bitCount(first) == 1u) ? last : first;
#endif
}

// Of pixels in rows, those that `first` may share with and that come after it; a bit each.
uint sharers(Cell cell, uint first, uint partners) {
  uint joined = 0u;
  for (uint i = first + 1u; i < 4u; ++i) {
    const uint both = 1u << first | 1u << i;
    if ((cell.covered & both) == both && (partners >> (first ^ i) & 1u) != 0u && shares(cell, first, i))
      joined |= 1u << i;
  }
  return joined;
}

// primaries: a bit a pixel. texels: of copy_bits, a byte a pixel. Places in a cell are constants once the loops are
// unrolled: no array is looked up by a number that is not known.
void split(Cell cell, out uint primaries, out uint texels) {
  const uint partners = partners_at(rate_of(cell));
  uint rest = cell.covered;
  primaries = 0u;
  texels = 0u;
  for (uint first = 0u; first < 4u; ++first) {
    if ((rest >> first & 1u) == 0u) continue;
    const uint members = 1u << first | (sharers(cell, first, partners) & rest);
    const uint primary = primary_of(members);
    primaries |= 1u << primary;
    rest &= ~members;
    for (uint apart = 1u; apart < 4u; ++apart) {
      const uint other = primary ^ apart;
      if ((members >> other & 1u) == 0u) continue;
      texels |= kCopyDuplicate << 8u * other;
      texels |= 1u << apart - 1u << 8u * primary;  // kCopyHorizontal, kCopyVertical, kCopyDiagonal
    }
  }
}
