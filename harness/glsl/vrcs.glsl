// What a shading pass puts before and after its work to shade primaries and copy what they come out as (Fuller, Hammer
// 2025, VRCSPrefix and VRCSPostFix; lists by kernels/vrcs_coordinates). The includer declares, before:
//   #define VRCS_EXTENT  <the screen, uvec2>
//   #define VRCS_RESULT  <type of what a pixel comes out as>
// of the lists the ones that it reads:
//   READS(n, uint, tiles);    #define VRCS_TILES tiles
//   READS(n, uint, entries);  #define VRCS_ENTRIES entries
//   #define VRCS_FRAME  <the frame's number, as the lists were made with>
// or
//   READS(n, uint, list);        #define VRCS_LIST list
//   READS(n, uint, list_count);  #define VRCS_LIST_COUNT list_count
// and defines, after, how a result is stored: void vrcs_store(uvec2 pixel, VRCS_RESULT result) { ... }
// Between the two it shades as ever:
//   VrcsPixel p = vrcs_tile_pixel(tile, lane);  // or vrcs_list_pixel(i)
//   if (p.code == kVrcsSky || p.code == kVrcsNoWork) return;
//   vrcs_postfix(p, <what the pixel p.at comes out as>);
// No pixel off the screen comes out of the prefix, nor goes to vrcs_store, whatever the lists hold.
#ifndef HARNESS_GLSL_VRCS
#define HARNESS_GLSL_VRCS
#include "harness/formats/pixel_commands.h"
#include "harness/formats/vrcs.h"

const uint kVrcsSky = 0u;     // nothing in the tile
const uint kVrcsAll = 1u;     // every pixel of the tile is shaded: `at` is the lane's own, and may have no surface
const uint kVrcsWork = 2u;    // `at` is a primary
const uint kVrcsNoWork = 3u;  // past the list's end, or off the screen

struct VrcsPixel {
  uvec2 at;
  uint copies;  // kCopyHorizontal, ...
  uint code;
  uint word;    // the tile's
  uint depth;   // of an entry with depth its code, else 0
};

void vrcs_store(uvec2 pixel, VRCS_RESULT result);

bool vrcs_on_screen(uvec2 pixel) { return pixel.x < VRCS_EXTENT.x && pixel.y < VRCS_EXTENT.y; }

VrcsPixel vrcs_checked(VrcsPixel p) {
#ifndef MUTANT_9601  // lists are trusted
  if (!vrcs_on_screen(p.at)) p.code = kVrcsNoWork;
#endif
  return p;
}

#ifdef VRCS_TILES
uint vrcs_tiles_across() { return (VRCS_EXTENT.x + kVrcsTileSide - 1u) / kVrcsTileSide; }
uint vrcs_tile_count() { return vrcs_tiles_across() * ((VRCS_EXTENT.y + kVrcsTileSide - 1u) / kVrcsTileSide); }

// The pixel of the tile that a lane stands for where all are shaded.
uvec2 vrcs_own_pixel(uint tile, uint lane) {
  const uvec2 first = uvec2(tile % vrcs_tiles_across(), tile / vrcs_tiles_across()) * kVrcsTileSide;
  const uint cell = lane / 4u;
  return first + uvec2(cell % 8u, cell / 8u) * kCellSide + uvec2(lane & 1u, lane >> 1u & 1u);
}

// tile: below vrcs_tile_count(). lane: 0 to 255, side by side in a subgroup, so that whole ones have nothing to do.
// A pass that works out fog defines VRCS_SHADE_FOG and shades all of fogged tiles.
VrcsPixel vrcs_tile_pixel(uint tile, uint lane) {
  const uvec2 first = uvec2(tile % vrcs_tiles_across(), tile / vrcs_tiles_across()) * kVrcsTileSide;
  const uint word = VRCS_TILES[tile], count = word & kVrcsTileCount;
  VrcsPixel p = VrcsPixel(first, 0u, kVrcsSky, word, 0u);
  if (count == 0u) return p;
#ifdef MUTANT_9602  // the last list that saves a wave is not taken
  bool all = count >= kVrcsTileEntries;
#else
  bool all = count > kVrcsTileEntries;
#endif
#ifdef VRCS_SHADE_FOG
  all = all || (word & kVrcsTileFog) != 0u;
#endif
  if (all) {
    p.at = vrcs_own_pixel(tile, lane);
    p.code = kVrcsAll;
    return vrcs_checked(p);
  }
  p.code = kVrcsNoWork;
#ifdef MUTANT_9603  // one lane too many
  if (lane > count) return p;
#else
  if (lane >= count) return p;
#endif
  p.code = kVrcsWork;
  if ((word & kVrcsTile2x2) != 0u) {  // no entries: the pixel is worked out
    if (lane >= kVrcsTileCells) {
      p.code = kVrcsNoWork;
      return p;
    }
#ifdef MUTANT_9604  // the upper left one in every frame
    p.at = first + uvec2(lane % 8u, lane / 8u) * kCellSide;
#else
    p.at = first + uvec2(lane % 8u, lane / 8u) * kCellSide + (VRCS_FRAME & 1u);
#endif
    p.copies = kCopyBits;
    return vrcs_checked(p);
  }
  const uint entry = VRCS_ENTRIES[tile * kVrcsTileEntries + lane];
  p.at = first + uvec2(entry & 15u, entry >> kVrcsEntryYShift & 15u);
  p.copies = entry >> kVrcsEntryCopyShift & kCopyBits;
  p.depth = entry >> kVrcsEntryDepthShift;
  return vrcs_checked(p);
}
#endif

#ifdef VRCS_LIST
// i: the thread's number in a dispatch of kVrcsListGroup threads a group over the list, which holds as many entries as
// the screen has pixels at most.
VrcsPixel vrcs_list_pixel(uint i) {
  VrcsPixel p = VrcsPixel(uvec2(0u), 0u, kVrcsNoWork, 0u, 0u);
  if (i >= min(VRCS_LIST_COUNT[0], VRCS_EXTENT.x * VRCS_EXTENT.y)) return p;
  const uint entry = VRCS_LIST[i], mask = (1u << kEntryCoordinateBits) - 1u;
  if ((entry & kEntryInvalid) != 0u) return p;
  p.at = uvec2(entry & mask, entry >> kEntryCoordinateBits & mask);
  p.copies = entry >> kEntryCopyShift & kCopyBits;
  p.code = kVrcsWork;
  return vrcs_checked(p);
}
#endif

void vrcs_copy(uvec2 pixel, VRCS_RESULT result) {
#ifdef MUTANT_9605  // copies beyond the screen's last column and row
  vrcs_store(pixel, result);
#else
  if (vrcs_on_screen(pixel)) vrcs_store(pixel, result);
#endif
}

// For a pixel with something to do. Where all are shaded there are no copies.
void vrcs_postfix(VrcsPixel p, VRCS_RESULT result) {
  vrcs_store(p.at, result);
  const uvec2 other = p.at ^ 1u;
  if ((p.copies & kCopyHorizontal) != 0u) vrcs_copy(uvec2(other.x, p.at.y), result);
  if ((p.copies & kCopyVertical) != 0u) vrcs_copy(uvec2(p.at.x, other.y), result);
#ifndef MUTANT_9606  // the diagonal is forgotten
  if ((p.copies & kCopyDiagonal) != 0u) vrcs_copy(other, result);
#endif
}

#endif
