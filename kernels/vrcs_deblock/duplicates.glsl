// Which pixels of a cell are duplicates, and of which kind. A group is a tile, a thread a cell of 2x2 pixels. The threads
// take entries and mark what these name, in a word a cell; then each looks up its cell's. So a pixel has one kind, whatever
// the lists say.
#include "harness/glsl/ports.glsl"
#include "kernels/vrcs_deblock/layout.h"

layout(local_size_x = kVrcsTileCells) in;
READS(0, uint, tiles);
READS(1, uint, entries);
PARAMS(DeblockParams);

// Four bits a pixel, in rows: kCopyHorizontal, kCopyVertical, kCopyDiagonal, and whether it is a primary.
const uint kPrimary = 8u;
shared uint marks[kVrcsTileCells];

bool on_screen(ivec2 pixel) {
#ifdef MUTANT_3  // the last column is not on it
  return all(greaterThanEqual(pixel, ivec2(0))) && pixel.x + 1 < int(params.width) && pixel.y < int(params.height);
#else
  return all(greaterThanEqual(pixel, ivec2(0))) && pixel.x < int(params.width) && pixel.y < int(params.height);
#endif
}

// Of a cell's pixel that is shaded, and those that copy it.
uint marks_of(uint pixel, uint copies) {
  uint all = kPrimary << 4u * pixel;
  all |= (copies & kCopyHorizontal) << 4u * (pixel ^ 1u);
  all |= (copies & kCopyVertical) << 4u * (pixel ^ 2u);
#ifndef MUTANT_5  // the diagonal duplicate is forgotten
  all |= (copies & kCopyDiagonal) << 4u * (pixel ^ 3u);
#endif
  return all;
}

// Every cell is whole, one surface and shaded once: no entry says so.
uint marks_by_place() {
#ifdef MUTANT_4  // the upper left in every frame
  return marks_of(0u, kCopyBits);
#else
  return marks_of((params.frame & 1u) * 3u, kCopyBits);
#endif
}

void mark(uint entry) {
  const uint x = entry & 15u, y = entry >> kVrcsEntryYShift & 15u;
  atomicOr(marks[y / 2u * 8u + x / 2u], marks_of((y & 1u) * 2u + (x & 1u), entry >> kVrcsEntryCopyShift & kCopyBits));
}

// The marks of a cell; none where everything stays as it is. Called by all threads of the group.
uint marks_of_cell(uint tile, uint cell) {
  const uint word = tiles[tile], count = word & kVrcsTileCount;
#ifdef MUTANT_6  // 224 entries are taken for too many
  if ((word & (kVrcsTileSky | kVrcsTile1x1)) != 0u || count >= kVrcsTileEntries) return 0u;
#else
  if ((word & (kVrcsTileSky | kVrcsTile1x1)) != 0u || count > kVrcsTileEntries) return 0u;
#endif
#ifdef MUTANT_7  // fogged tiles are not deblocked, as in the game's first release
  if ((word & kVrcsTileFog) != 0u) return 0u;
#endif
  if ((word & kVrcsTile2x2) != 0u) return marks_by_place();
  marks[cell] = 0u;
  barrier();
#ifdef MUTANT_8  // an entry too many
  for (uint i = cell; i <= count; i += kVrcsTileCells) mark(entries[tile * kVrcsTileEntries + i]);
#else
  for (uint i = cell; i < count; i += kVrcsTileCells) mark(entries[tile * kVrcsTileEntries + i]);
#endif
#ifndef MUTANT_9  // what other subgroups have yet to mark is missing
  barrier();
#endif
  return marks[cell];
}

// kCopyHorizontal, kCopyVertical or kCopyDiagonal of a cell's pixel, or 0: it stays as it is. A primary stays; of several
// kinds the first counts.
uint kind_of(uint marked, uint pixel) {
  const uint all = marked >> 4u * pixel & 15u;
  return (all & kPrimary) != 0u ? 0u : all & (0u - all);
}
