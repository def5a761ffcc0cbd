// Cases for the cluster lists.
#pragma once
#include "harness/oracle.h"
#include "kernels/cluster_lists/layout.h"

namespace assay::cluster_lists {

// 256 lights, as many decals, a sixteenth as many probes in 16x8x24 cells; from 1920 pixels on 4096, at 3840 in
// 120x68x24 cells. A cell meets an eighth of 64 neighbouring items of
// each kind, and there is room for just that.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();

}  // namespace assay::cluster_lists
