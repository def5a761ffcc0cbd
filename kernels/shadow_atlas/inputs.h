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
Case few_move(Extent);  // of typical what is drawn in a frame in which only what moves moved, in an eighth of the tiles
Case frame(const FrameInputs&);

}  // namespace assay::shadow_atlas
