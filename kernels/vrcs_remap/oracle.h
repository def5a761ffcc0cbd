// What the stores through the lists must leave.
#pragma once
#include "harness/kernel.h"
#include "harness/vrcs_oracle.h"
#include "kernels/vrcs_remap/layout.h"

namespace assay::vrcs_remap {

uint64_t tiles(const Case&);
uint64_t entries(const Case&);

// Exact. Where the lists are the screen's, each covered pixel is stored once and no other is, whatever the lists say.
// Answers are named after the variant: "visits of tile_list".
Answer remap(const Case&);

}  // namespace assay::vrcs_remap
