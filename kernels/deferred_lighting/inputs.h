#pragma once
#include "harness/oracle.h"

namespace assay::deferred_lighting {

Case random_case(Random&);
std::vector<std::string> branches();
std::vector<HardCase> hard_cases();
std::vector<HardCase> cell_cases();       // those of hard_cells.cpp
std::vector<HardCase> primary_cases();    // those of hard_primaries.cpp
std::vector<HardCase> shadow_cases();     // those of hard_shadows.cpp
std::vector<HardCase> sound_primaries();  // of these the ones whose lists are the screen's
std::vector<Case> smaller(const Case&);   // fewer lights, then fewer pixels
Case typical(Extent);                     // a hall with three lights
Case typical_with(Extent, uint32_t lights);
Case in_frame(const FrameInputs&);

}  // namespace assay::deferred_lighting
