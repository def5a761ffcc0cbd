// What the depth pyramid must be.
#pragma once
#include "harness/kernel.h"
#include "kernels/hi_z/layout.h"

namespace assay::hi_z {

Extent size_of_level(Extent image, uint32_t level);  // level from 1; texels
uint32_t level_count(Extent image);                  // 1 at least
uint64_t texels(const Case&);                        // of all levels

// Exact: each texel from the pixels that it covers.
Answer pyramid(const Case&);

}  // namespace assay::hi_z
