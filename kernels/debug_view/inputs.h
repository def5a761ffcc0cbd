#pragma once
#include "harness/oracle.h"

namespace assay::debug_view {

Case random_case(Random&);
std::vector<std::string> branches();
std::vector<HardCase> hard_cases();
std::vector<Case> smaller(const Case&);
Case typical(Extent);  // the workload view of rectangles of surfaces, two workloads
Case in_frame(const FrameInputs&);

}  // namespace assay::debug_view
