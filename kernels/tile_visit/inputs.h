// Cases for the visit of tile lists.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/tile_visit/layout.h"

namespace assay::tile_visit {

// Three workloads that share out nearly all tiles, each list in an order of its own.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();

}  // namespace assay::tile_visit
