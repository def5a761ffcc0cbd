// Smaller cases of kernels that draw by commands, for the shrinker.
#pragma once
#include <vector>

#include "harness/kernel.h"

namespace assay::raster {

// Halves of the commands in the port `draws`, halves of each command's triangles, halves of its instances.
std::vector<Case> smaller_draws(const Case&);

}  // namespace assay::raster
