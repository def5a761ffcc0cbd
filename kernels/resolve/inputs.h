#pragma once
#include "harness/oracle.h"

namespace assay::resolve {

Case random_case(Random&);
std::vector<std::string> branches();
std::vector<HardCase> hard_cases();
std::vector<Case> smaller(const Case&);  // crops
Case typical(Extent);                    // a log-normal picture under automatic exposure
Case in_frame(const FrameInputs&);

}  // namespace assay::resolve
