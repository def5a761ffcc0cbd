// Which pixels variable-rate compute shading shades and which copy them (Fuller, Hammer 2025): the statement of
// kernels/vrcs_coordinates, and what other kernels' generators make their lists with. Host only.
#pragma once
#include <functional>

#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/kernel.h"

namespace assay::vrcs {

// Pixels and cells in rows.
struct View {
  Extent extent = {};
  std::span<const uvec2> visibility = {};
  std::span<const uint8_t> rates = {};  // a cell
  std::span<const float> depth = {};
  uint frame = 0;
  bool all_1x1 = false;
  float fog_depth = 0;
};
inline Extent cells_of(Extent e) { return tiles_of(e, kCellSide); }
inline uint64_t tiles_in(Extent e) { return tile_count(e, kVrcsTileSide); }

// A pixel's depth, a positive normal number; else 0, as far as can be.
float depth_of(float);

struct Primary {
  uint x, y;    // on the screen
  uint copies;  // kCopyHorizontal, ...
};
struct Tile {
  uint word = 0;
  std::vector<Primary> primaries = {};  // in the order of lanes
};
struct Coordinates {
  std::vector<Tile> tiles;
  std::vector<uint8_t> copy_bits;  // a pixel
};

// Whether two covered pixels of different triangles, by their places in the screen, may share nevertheless.
using Sharing = std::function<bool(size_t, size_t)>;
Coordinates coordinates_of(const View&, const Sharing& = {});

bool is_stored(const Tile&);  // its primaries are entries
uint entry_of(const Primary&);

// As buffers: a word and room for kVrcsTileEntries a tile. What lies past a list's end may be anything: here all ones.
struct Lists {
  std::vector<uint> tiles, entries;
};
Lists lists_of(const Coordinates&);

}  // namespace assay::vrcs
