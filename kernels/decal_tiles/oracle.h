// Which tiles the list must have.
#pragma once
#include "harness/kernel.h"
#include "kernels/decal_tiles/layout.h"

namespace assay::decal_tiles {

uint64_t tiles(const Case&);

// Exact. The ports' names followed by " of <variant>".
Answer listed_tiles(const Case&);

// For the figures: of each tile, whether a pixel of it is in a cell that lists a decal.
std::vector<bool> tiles_by_pixel(const Case&);

}  // namespace assay::decal_tiles
