// Tile words and entries as kernels/vrcs_coordinates makes them by triangle: what the generator needs of the rules.
#pragma once
#include "harness/kernel.h"
#include "kernels/vrcs_deblock/layout.h"

namespace assay::vrcs_deblock {

struct Lists {
  std::vector<uint> tiles, entries;  // kVrcsTileEntries a tile
};

// visibility: a pixel; rates: a cell; both in rows.
Lists lists_of(Extent, std::span<const uvec2> visibility, std::span<const uint8_t> rates, uint frame);

}  // namespace assay::vrcs_deblock
