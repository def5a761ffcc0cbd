// Pixels share whose triangles' normals are close, each rebuilt from the depths of three pixels of its triangle.
// Reversed depth d = near / w is linear on the screen over a plane: with its slopes gx, gy a pixel and the focal lengths
// fx, fy the normal in view space is (gx fx, gy fy, d - gx (x - cx) - gy (y - cy)), but for its length.
// Loop turns of an invocation: 8 neighbours of each of at most 6 pairs' pixels.
#include "kernels/vrcs_coordinates/normals.glsl"

shared uvec3 tile_pixels[256];  // visibility, depth; in rows of 16

void prepare_sharing(uint tile) {
  const uvec2 first = uvec2(tile % ceil_div(params.width, kVrcsTileSide), tile / ceil_div(params.width, kVrcsTileSide)) *
                      kVrcsTileSide;
  for (uint i = gl_LocalInvocationID.x; i < kVrcsTilePixels; i += 64u) {
    const uvec2 pixel = first + uvec2(i % kVrcsTileSide, i / kVrcsTileSide);
    tile_pixels[i] = uvec3(kVisibilityNone, kVisibilityNone, 0u);
    if (on_screen(pixel, extent())) tile_pixels[i] = uvec3(texelFetch(visibility, ivec2(pixel), 0).xy, depth_bits(pixel));
  }
}

// In units of 2^-23 of the exponent of `as`, from 2^22 to 2^25; -1 where it is not within a power of two of it.
int scaled(uint depth, uint as) {
  const int up = int(depth >> 23u) - int(as >> 23u);
  if (depth == 0u || abs(up) > 1) return -1;
  return up < 0 ? int(mantissa(depth) >> 1u) : int(mantissa(depth) << up);
}

// How far numbers of this magnitude must be shifted to have at most `bits`.
int excess(int magnitude, int bits) { return max(findMSB(magnitude) + 1 - bits, 0); }

// D: depth at the pixel; a, b: places of two others relative to it, with their depths less D.
ivec3 normal_of(uvec2 pixel, int D, ivec3 a, ivec3 b) {
  int turn = a.x * b.y - a.y * b.x;  // 1 or 2, either sign
  int gx = a.z * b.y - b.z * a.y, gy = b.z * a.x - a.z * b.x;
#ifndef MUTANT_18  // the order of the three turns the normal over
  if (turn < 0) turn = -turn, gx = -gx, gy = -gy;
#endif
  const int steep = excess(max(abs(gx), abs(gy)), 15);
  gx >>= steep, gy >>= steep;
  const ivec2 focal = ivec2(clamp(uvec2(params.focal_x, params.focal_y), 1u, 16383u));
  const ivec2 from_middle = 2 * ivec2(pixel) + 1 - ivec2(extent());  // half pixels
  const ivec3 n = ivec3(2 * gx * focal.x, 2 * gy * focal.y,
                        2 * (turn * D >> steep) - gx * from_middle.x - gy * from_middle.y);
  return n >> excess(max(max(abs(n.x), abs(n.y)), abs(n.z)), 14);
}

// The first two in rows around the pixel that show its triangle and are not in line with it. The neighbourhood ends with
// the 8x8 block. Zero where there are none.
ivec3 rebuilt_normal(uvec2 pixel) {
  const ivec2 at = ivec2(pixel % kVrcsTileSide), block = at / int(kBlockSide);
  const uvec3 here = tile_pixels[at.y * 16 + at.x];
  if (here.z == 0u) return ivec3(0);
  const int D = scaled(here.z, here.z);
  ivec3 second = ivec3(0);
  for (int i = 0; i < 9; ++i) {
    const ivec2 step = ivec2(i % 3 - 1, i / 3 - 1), there = at + step;
    if (i == 4 || any(lessThan(there, ivec2(0))) || there / int(kBlockSide) != block) continue;
    const uvec3 pixel_there = tile_pixels[there.y * 16 + there.x];
    const int there_D = scaled(pixel_there.z, here.z);
    if (pixel_there.xy != here.xy || there_D < 0) continue;
    if (second.xy == ivec2(0)) {
      second = ivec3(step, there_D - D);
      continue;
    }
#ifdef MUTANT_19  // three in a line
    return normal_of(pixel, D, second, ivec3(step, there_D - D));
#else
    if (second.x * step.y != second.y * step.x) return normal_of(pixel, D, second, ivec3(step, there_D - D));
#endif
  }
  return ivec3(0);
}

bool shares_across(Cell cell, uint a, uint b) {
  if (!close_depths(cell.depth[a], cell.depth[b])) return false;
  return close_normals(rebuilt_normal(cell.first + offset_of(a)), rebuilt_normal(cell.first + offset_of(b)));
}
