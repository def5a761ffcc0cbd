// Random cases, hard cases, a typical atlas; the frame's.
#pragma once
#include "harness/oracle.h"
#include "kernels/shadow_atlas/layout.h"

namespace assay::shadow_atlas {

Inputs inputs();
std::vector<HardCase> hard_cases();
std::vector<HardCase> hostile_cases();
std::vector<Mutant> mutants();
Case typical(Extent);
Case frame(const FrameInputs&);

}  // namespace assay::shadow_atlas
