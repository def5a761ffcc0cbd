// The tone curve as the table that the shader compares with.
#pragma once
#include <vector>

namespace assay::resolve {

// [k] is the least float that is given code k by Narkowicz's fit of the ACES curve (2015), sRGB's encoding and rounding
// to the nearest of 256 codes; [0] is 0.
std::vector<float> code_thresholds();

}  // namespace assay::resolve
