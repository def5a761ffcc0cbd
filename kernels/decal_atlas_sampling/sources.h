// Whose material each pixel comes out with in the variants over the list of tiles that have decals.
#pragma once
#include "harness/kernel.h"

namespace assay::decal_atlas_sampling {

constexpr uint32_t kNobody = 0xffffffffu;  // the pixel stays as it is

// Of each pixel: itself, its primary, or nobody.
std::vector<uint32_t> sources_by_tiles(const Case&);
std::vector<uint32_t> sources_by_primaries(const Case&);

}  // namespace assay::decal_atlas_sampling
