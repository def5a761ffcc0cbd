#pragma once
#include "harness/oracle.h"

namespace assay::particles {

Inputs inputs();
std::vector<Mutant> mutants();
Case typical(Extent);
Case in_frame(const FrameInputs&);
std::vector<HardCase> hard_cases();
// Against light at every pixel, by the kind of light, the rectangle's side and its encoding.
ErrorTable error_table();

}  // namespace assay::particles
