#pragma once
#include "harness/oracle.h"

namespace assay::material_features {

Case random_case(Random&);
std::vector<std::string> branches();
std::vector<HardCase> hard_cases();
std::vector<Case> smaller(const Case&);  // crops
Case typical(Extent);                    // rectangles of a few hundred surfaces, as a frame has them

}  // namespace assay::material_features
