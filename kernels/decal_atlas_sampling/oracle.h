#pragma once
#include "harness/kernel.h"

namespace assay::decal_atlas_sampling {

// Of base_roughness and normal as their unpacked fields (below). The same under kTaps for several samples along the
// longer derivative, under kBits where the decals are taken from the bits, under kBlocks of pages in blocks; under
// kTiles on the listed tiles alone, under kPrimaries there and copied from primaries.
Answer decaled(const Case&);

inline const std::string kTaps = "taps_";
inline const std::string kBits = "bits_";
inline const std::string kBlocks = "blocks_";
inline const std::string kTiles = "tiles_";
inline const std::string kPrimaries = "primaries_";

Unpack unpack_base_roughness();  // vec4: square roots of the linear colour; roughness
Unpack unpack_normal();          // vec3, unit

}  // namespace assay::decal_atlas_sampling
