// What each texel of the two images may hold, from the same bytes that the draws read.
#pragma once
#include "kernels/shadow_atlas/layout.h"

#include "harness/oracle.h"

namespace assay::shadow_atlas {

// Whether the tile lies in the atlas.
bool is_tile(const ShadowTile&, const ShadowCounts&);
// Of ports: still and depth, and `redrawn`, what depth is without a cache.
Answer shadows(const Case&);

}  // namespace assay::shadow_atlas
