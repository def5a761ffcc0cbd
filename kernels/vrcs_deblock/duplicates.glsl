// Which pixels of a tile are duplicates, and of which kind. A group is a tile. Its threads take an entry each and mark the
// pixels that it names; then each looks up the mark of its own pixel. So a pixel has one kind, whatever the lists say.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_deblock/layout.h"

layout(local_size_x = 256) in;
READS(0, uint, tiles);
READS(1, uint, entries);
PARAMS(DeblockParams);

const uint kPrimary = 8u;
shared uint marks[kVrcsTilePixels];

bool on_screen(ivec2 pixel) {
#ifdef MUTANT_3  // the last column is not on it
  return all(greaterThanEqual(pixel, ivec2(0))) && pixel.x + 1 < int(params.width) && pixel.y < int(params.height);
#else
  return all(greaterThanEqual(pixel, ivec2(0))) && pixel.x < int(params.width) && pixel.y < int(params.height);
#endif
}

// Every cell is whole, one surface and shaded once: no entry says so.
uint kind_by_place(uint i) {
#ifdef MUTANT_4  // the upper left in every frame
  const uint primary = 0u;
#else
  const uint primary = params.frame & 1u;
#endif
  const bool across = (i & 1u) != primary, down = (i >> 4 & 1u) != primary;
  return across ? (down ? kCopyDiagonal : kCopyHorizontal) : (down ? kCopyVertical : 0u);
}

// Of an entry's pixel and those that copy it.
void mark(uint entry) {
  const uint at = entry & 255u, copies = entry >> kVrcsEntryCopyShift & kCopyBits;
  atomicOr(marks[at], kPrimary);
  if ((copies & kCopyHorizontal) != 0u) atomicOr(marks[at ^ 1u], kCopyHorizontal);
  if ((copies & kCopyVertical) != 0u) atomicOr(marks[at ^ 16u], kCopyVertical);
#ifndef MUTANT_5  // the diagonal duplicate is forgotten
  if ((copies & kCopyDiagonal) != 0u) atomicOr(marks[at ^ 17u], kCopyDiagonal);
#endif
}

// kCopyHorizontal, kCopyVertical or kCopyDiagonal of the tile's i-th pixel, row by row, or 0: it stays as it is. A
// primary stays; of several kinds the first counts. Called by all threads of the group.
uint kind_of(uint tile, uint i) {
  const uint word = tiles[tile], count = word & kVrcsTileCount;
#ifdef MUTANT_6  // 224 entries are taken for too many
  if ((word & (kVrcsTileSky | kVrcsTile1x1)) != 0u || count >= kVrcsTileEntries) return 0u;
#else
  if ((word & (kVrcsTileSky | kVrcsTile1x1)) != 0u || count > kVrcsTileEntries) return 0u;
#endif
#ifdef MUTANT_7  // fogged tiles are not deblocked, as in the game's first release
  if ((word & kVrcsTileFog) != 0u) return 0u;
#endif
  if ((word & kVrcsTile2x2) != 0u) return kind_by_place(i);
  marks[i] = 0u;
  barrier();
#ifdef MUTANT_8  // an entry too many
  if (i <= count) mark(entries[tile * kVrcsTileEntries + i]);
#else
  if (i < count) mark(entries[tile * kVrcsTileEntries + i]);
#endif
#ifndef MUTANT_9  // what other subgroups have yet to mark is missing
  barrier();
#endif
  const uint all = marks[i];
  return (all & kPrimary) != 0u ? 0u : all & (0u - all);
}
