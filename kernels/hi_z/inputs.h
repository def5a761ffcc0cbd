// Cases for the depth pyramid.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/hi_z/layout.h"

namespace assay::hi_z {

// A floor, walls at several depths, and a third of sky.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();
Case in_frame(const FrameInputs&);

// For hard.cpp. `depth`: reversed, pixels in scan order.
Case case_of(Extent, const std::vector<float>& depth);
std::vector<HardCase> hard_cases();

}  // namespace assay::hi_z
