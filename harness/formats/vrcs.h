// Variable-rate compute shading (Fuller, Hammer 2025): how coarsely each 2x2 pixels are shaded, and which of their
// pixels are shaded for the others.
#ifndef FORMATS_VRCS_H
#define FORMATS_VRCS_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Rates of a cell of 2x2 pixels, r8_uint, a texel a cell, the last column and row rounded up: log2 of the width from
// bit 2 on, of the height below, as VK_KHR_fragment_shading_rate has them. 1x2 is two pixels high: they share.
SHARED_CONST uint kRate1x1 = 0u;
SHARED_CONST uint kRate1x2 = 1u;
SHARED_CONST uint kRate2x1 = 4u;
SHARED_CONST uint kRate2x2 = 5u;
SHARED_CONST uint kCellSide = 2u;

// How rates are chosen.
SHARED_CONST uint kAllFull = 1u;  // 1x1 everywhere, for want of a picture before (first frame, cut, new size)
SHARED_CONST uint kWeber = 2u;    // the error that passes grows with the mean, else it is the same everywhere

// Luma, rg8_unorm, after exposure and tone map, as displayed: red of opaque surfaces, green after blended ones.

// Tiles of 16x16 pixels, in rows; a list of primaries each, in the order of lanes: cell after cell in rows, of a cell
// upper left, upper right, lower left, lower right.
SHARED_CONST uint kVrcsTileSide = 16u;
SHARED_CONST uint kVrcsTilePixels = 256u;
SHARED_CONST uint kVrcsTileCells = 64u;
// A list that does not save a wave of 32 is not stored: with more primaries than this the whole tile is shaded.
SHARED_CONST uint kVrcsTileEntries = 224u;

// A tile's word: how many primaries it has, and what holds for all of it.
SHARED_CONST uint kVrcsTileCount = 0x1ffu;  // bits 0..8
SHARED_CONST uint kVrcsTileSky = 0x200u;    // no surface; its count is 0
SHARED_CONST uint kVrcsTile1x1 = 0x400u;    // every covered pixel is a primary
SHARED_CONST uint kVrcsTile2x2 = 0x800u;    // every cell is covered and shaded once: no entry is stored (below)
SHARED_CONST uint kVrcsTileFog = 0x1000u;   // fogged: passes that work out fog shade all of it

// Of such a tile, lane i shades cell i for its other three pixels: its upper left pixel in even frames, its lower right
// one in odd ones.

// An entry: where in the tile, which neighbours copy it (across, down, diagonally: its coordinate XOR 1), and with
// depth, 21 bits of it.
SHARED_CONST uint kVrcsEntryYShift = 4u;       // x in bits 0..3
SHARED_CONST uint kVrcsEntryCopyShift = 8u;    // kCopyHorizontal, kCopyVertical, kCopyDiagonal of pixel_commands.h
SHARED_CONST uint kVrcsEntryDepthShift = 11u;  // 21 bits: view depth, 0 at the near plane
SHARED_CONST uint kVrcsDepthCodes = 0x1fffffu;

// The list of a whole screen: entries of formats/pixel_commands.h, none invalid; a group of its consumer takes so many.
SHARED_CONST uint kVrcsListGroup = 64u;

SHARED_END
#endif
