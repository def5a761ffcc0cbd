// A tile's listed pixels, group after group: of each shader the uniform groups, then the divergent ones, each ascending
// by material. The count leaves them as kTilePixels words a tile and a bit for each position at which a group begins:
// the scatter need not look at the screen again, nor find a surface.
//   bits 0..9 the pixel of the tile, row by row; 10..12 copy bits; 13..30 key; 31 whether the group is divergent
const uint kListCopyShift = 10u;
const uint kListKeyShift = 13u;
const uint kListDivergent = 1u << kKeyBits;  // beside the key

// Of tile_groups, kTileWords a tile:
const uint kStartWords = kTilePixels / 32u;   // of bits
const uint kWordsWithStarts = kStartWords;    // a bit for each of them that is not 0
const uint kListedWord = kStartWords + 1u;    // pixels of the list
const uint kUnlistedWord = kStartWords + 2u;  // pixels of the tile that are covered and in no list

// Where a surface's pixels go: position in the list in bits 0..9, above it the key and whether the group is divergent.
const uint kPlaceBits = 10u;  // kTilePixels
const uint kNowhere = 0xffffffffu;
uint position_of(uint place) { return place & kTilePixels - 1u; }
