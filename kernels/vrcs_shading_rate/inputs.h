// Cases for the shading rates.
#pragma once
#include "harness/kernel.h"
#include "kernels/vrcs_shading_rate/layout.h"

namespace assay::vrcs_shading_rate {

Case typical(Extent);
Case in_frame(const FrameInputs&);
Inputs inputs();
std::vector<Mutant> mutants();

}  // namespace assay::vrcs_shading_rate
