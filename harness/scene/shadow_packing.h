// Where in the shadow atlas each view of a light has its tile.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "harness/formats/shadow.h"

namespace assay::scene {

constexpr uint32_t kLeastTile = 64, kMostAtlas = 4096;  // texels a side; powers of two

// What a light asks for: so many tiles of one side, a power of two from kLeastTile to kMostAtlas.
struct TileWish {
  uint32_t light = 0;  // its number in the scene
  uint32_t views = 1;  // at most 8
  uint32_t side = kLeastTile;
  double importance = 0;
};

using TileKey = uint32_t;  // light * 8 + view
inline TileKey tile_key(uint32_t light, uint32_t view) { return light * 8 + view; }
using Tiles = std::map<TileKey, ShadowTile>;

// An atlas of powers of two, as high as wide or half as high, with tiles that do not overlap, each at a multiple of its
// side.
struct Packing {
  uint32_t width = 0, height = 0;
  Tiles tiles = {};
  uint32_t halved = 0;   // lights that have smaller tiles than they asked for
  uint32_t dropped = 0;  // and none at all
};

// The smallest atlas that holds the wishes, or the one before where that does. A tile that keeps its side keeps its
// place in an atlas of that size, unless what is new finds no room beside. Wishes that `most` texels a side cannot hold
// are halved, the least important light's first (of equal ones the last), and dropped where all are smallest; what room
// is left goes back to the most important. A function of its arguments, whatever the order of the wishes.
Packing pack_tiles(std::vector<TileWish>, const Packing& before, uint32_t most = kMostAtlas);

}  // namespace assay::scene
