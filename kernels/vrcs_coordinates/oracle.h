// What the coordinates must be: the split of harness/vrcs_oracle.h, by triangle and by each rule that lets more share.
#pragma once
#include "harness/kernel.h"
#include "harness/vrcs_oracle.h"
#include "kernels/vrcs_coordinates/layout.h"

namespace assay::vrcs_coordinates {

uint64_t tiles(const Case&);
uint64_t entries(const Case&);
Extent cells(const Case&);

// An entry with depth: integers exact, the depth's code within what division and products may round.
struct DepthEntry {
  uint place;   // coordinates and copy bits
  float depth;  // code
};
SHARED_LAYOUT(DepthEntry, place, depth);
Bytes unpack_depth_entries(std::span<const std::byte>);

// Exact all but the codes of depth. Answers of the rules are named after the variant: "tiles of stored_normal".
Answer coordinates(const Case&);

}  // namespace assay::vrcs_coordinates
