// Which pixels the dispatches over tile lists must reach.
#pragma once
#include "harness/kernel.h"
#include "kernels/tile_visit/layout.h"

namespace assay::tile_visit {

uint64_t tiles(const Case&);
uint64_t workloads(const Case&);  // that are dispatched

Answer visit(const Case&);

}  // namespace assay::tile_visit
