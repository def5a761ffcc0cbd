// What the classification must produce, stated over pixels and tables.
#pragma once
#include "harness/kernel.h"
#include "kernels/tile_classification/layout.h"

namespace assay::tile_classification {

uint32_t live_workloads(const Case&);  // rows that are looked at
uint32_t live_passes(const Case&);
uint64_t tiles(const Case&);

// Exact masks, counts, arguments and statistics; each workload's tiles as a set.
Answer classify(const Case&);

}  // namespace assay::tile_classification
