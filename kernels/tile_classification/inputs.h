// Cases for the tile classification.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/tile_classification/layout.h"

namespace assay::tile_classification {

// A frame made of large coherent regions with fine detail in places, and the frame's two passes.
Case typical(Extent);
// Parameters and table of a frame; its features come from another kernel.
Case frame(const FrameInputs&);
Inputs inputs();
std::vector<Mutant> mutants();

// For hard.cpp: a case of the given features (row by row) that classifies by the frame's table.
Case case_of(Extent, const std::vector<uint>& features);
Case with_table(Case, const std::vector<Workload>&, uint passes);
std::vector<HardCase> hard_cases();

}  // namespace assay::tile_classification
