// Cases for the coordinates of variable-rate compute shading.
#pragma once
#include "harness/kernel.h"
#include "harness/vrcs_screens.h"
#include "kernels/vrcs_coordinates/layout.h"

namespace assay::vrcs_coordinates {

Inputs inputs();
Case typical(Extent);
Case in_frame(const FrameInputs&);
std::vector<Mutant> mutants();
ErrorTable figures_table();  // what each rule leaves to be shaded

// For hard.cpp. Frame 0, no fog, a near plane of 0.1 and a far one of 1000 metres, a view of 90 degrees.
Case case_of(const vrcs::Pictured&);
Case with_params(Case, const std::function<void(VrcsParams&)>& change);
std::vector<HardCase> hard_cases();

}  // namespace assay::vrcs_coordinates
