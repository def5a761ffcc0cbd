#pragma once
#include "harness/kernel.h"

namespace assay::debug_view {

uint64_t tiles(const Case&);
uint64_t workloads(const Case&);

// The picture, every pixel by rule; of the workload lists only what the indirect arguments reach.
Answer expected_image(const Case&);

}  // namespace assay::debug_view
