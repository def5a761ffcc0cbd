// Cases for the visit of variable-rate compute shading's lists.
#pragma once
#include "harness/kernel.h"
#include "harness/vrcs_screens.h"
#include "kernels/vrcs_remap/layout.h"

namespace assay::vrcs_remap {

Inputs inputs();
Case typical(Extent);
Case in_frame(const FrameInputs&);
std::vector<Mutant> mutants();

// For hard.cpp. The lists that the oracle of the coordinates makes of a screen, its tiles in the screen's list in the
// order that a seed gives. What lies behind a list is an entry of its own, which nobody may follow.
Case case_of(const vrcs::View&, uint64_t seed);
// Changed lists are nobody's: the oracle follows them. Inputs by name.
Case hostile(Case, const std::string& input, const std::function<void(std::vector<uint>&)>& change);
std::vector<HardCase> hard_cases();

}  // namespace assay::vrcs_remap
