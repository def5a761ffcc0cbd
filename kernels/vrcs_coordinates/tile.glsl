// A group a tile of 16x16 pixels, a thread a cell. The primaries of a row of 8 cells are the bits of a word, so where
// one stands in the list is a count of bits, whatever the subgroup.
// Loop turns of an invocation: the cell's, 8 rows, 4 pixels.
#include "kernels/vrcs_coordinates/cell.glsl"

layout(local_size_x = 64) in;
WRITES(3, uint, tiles);
WRITES(4, uint, entries);
layout(binding = 5, r8ui) uniform writeonly restrict uimage2D copy_bits;
#ifdef COMPACT
WRITES(6, uint, list);
UPDATES(7, uint, list_count);
shared uint first_of_list;
#endif

shared uint primaries_of_row[8];
shared uint facts;  // covered pixels; from bit 10 on, cells covered and shaded once; from bit 20 on, fogged cells

const uint kWholeShift = 10u, kFogShift = 20u;

uint tiles_across() { return ceil_div(params.width, kVrcsTileSide); }
uvec2 first_pixel(uint tile) { return uvec2(tile % tiles_across(), tile / tiles_across()) * kVrcsTileSide; }

bool is_fogged(Cell cell) {
  bool fogged = false;
  for (uint i = 0u; i < 4u; ++i)
#ifdef MUTANT_8  // the depth where fog begins is fogged
    if ((cell.covered >> i & 1u) != 0u && cell.depth[i] <= bits_of_depth(params.fog_depth)) fogged = true;
#else
    if ((cell.covered >> i & 1u) != 0u && cell.depth[i] < bits_of_depth(params.fog_depth)) fogged = true;
#endif
  return fogged;
}

uint word_of(uint count) {
  const uint covered = facts & 0x3ffu, whole = facts >> kWholeShift & 0x3ffu, fogged = facts >> kFogShift;
  uint word = count;
  if (count == 0u) word |= kVrcsTileSky;
  if (count != 0u && count == covered) word |= kVrcsTile1x1;
#ifdef MUTANT_9  // as many primaries as cells
  if (count == kVrcsTileCells) word |= kVrcsTile2x2;
#else
  if (whole == kVrcsTileCells) word |= kVrcsTile2x2;
#endif
  if (fogged != 0u) word |= kVrcsTileFog;
  return word;
}

#ifdef DEPTH_ENTRIES
// View depth, near plane over reversed depth, as a share of what lies beyond the near plane. No depth is the farthest.
uint depth_code(uint depth) {
  if (depth == 0u) return kVrcsDepthCodes;
  const float code = (params.near_plane / uintBitsToFloat(depth) - params.near_plane) * params.depth_scale + 0.5;
#ifdef MUTANT_10  // 20 bits
  return code > 0.0 ? uint(min(code, float(kVrcsDepthCodes))) >> 1u : 0u;
#else
  return code > 0.0 ? uint(min(code, float(kVrcsDepthCodes))) : 0u;
#endif
}
#else
uint depth_code(uint depth) { return 0u; }
#endif

// Of the tile's primaries, those of this cell, `at` the place of the first.
void store_entries(uint tile, Cell cell, uint primaries, uint texels, uint at, uint count) {
#ifdef MUTANT_11  // a list that just saves a wave is not stored
  const bool stored = count < kVrcsTileEntries;
#else
  const bool stored = count <= kVrcsTileEntries;
#endif
  const bool derived = (facts >> kWholeShift & 0x3ffu) == kVrcsTileCells;
  for (uint i = 0u; i < 4u; ++i) {
    if ((primaries >> i & 1u) == 0u) continue;
    const uvec2 pixel = cell.first + offset_of(i), within = pixel % kVrcsTileSide;
    const uint copies = texels >> 8u * i & kCopyBits;
#ifdef COMPACT
#ifdef MUTANT_12  // what no tile's list holds is in none
    if (stored)
#endif
    list[first_of_list + at] =
        pixel.x | pixel.y << kEntryCoordinateBits | copies << kEntryCopyShift;
#endif
    if (stored && !derived)
      entries[tile * kVrcsTileEntries + at] = within.x | within.y << kVrcsEntryYShift |
          copies << kVrcsEntryCopyShift | depth_code(cell.depth[i]) << kVrcsEntryDepthShift;
    ++at;
  }
}

void main() {
  const uint tile = spread_group(), thread = gl_LocalInvocationID.x;
  if (tile >= tiles_across() * ceil_div(params.height, kVrcsTileSide)) return;  // the whole group
  if (thread < 8u) primaries_of_row[thread] = 0u;
  if (thread == 8u) facts = 0u;
  prepare_sharing(tile);
  barrier();

  const Cell cell = cell_at(first_pixel(tile) + uvec2(thread % 8u, thread / 8u) * kCellSide);
  uint primaries, texels;
  split(cell, primaries, texels);
  const uint row = thread / 8u, shift = thread % 8u * 4u;
  atomicOr(primaries_of_row[row], primaries << shift);
  const bool whole = cell.covered == 15u && bitCount(primaries) == 1u;
  atomicAdd(facts, bitCount(cell.covered) | uint(whole) << kWholeShift | uint(is_fogged(cell)) << kFogShift);
  for (uint i = 0u; i < 4u; ++i) {
    const uvec2 pixel = cell.first + offset_of(i);
    if (on_screen(pixel, extent())) imageStore(copy_bits, ivec2(pixel), uvec4(texels >> 8u * i & 0xffu));
  }
#ifndef MUTANT_13  // the barrier dropped: what higher subgroups have yet to say is missing
  barrier();
#endif

  uint before = bitCount(primaries_of_row[row] & (1u << shift) - 1u), count = 0u;
  for (uint i = 0u; i < 8u; ++i) {
    if (i == row) before += count;
    count += bitCount(primaries_of_row[i]);
  }
  if (thread == 0u) tiles[tile] = word_of(count);
#ifdef COMPACT
  if (thread == 0u) first_of_list = atomicAdd(list_count[0], count);
  barrier();
#endif
  store_entries(tile, cell, primaries, texels, before, count);
}
