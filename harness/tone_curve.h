// The tone curve: the table that shaders compare with, and for oracles, which never see it, the curve itself. Host
// only.
#pragma once
#include <cstdint>
#include <vector>

namespace assay {

// [k] is the least float that is given code k by Narkowicz's fit of the ACES curve (2015), sRGB's encoding and rounding
// to the nearest of 256 codes; [0] is 0.
std::vector<float> code_thresholds();

// Of each bucket of formats/exposure.h, the code of its least float.
std::vector<uint32_t> bucket_codes(const std::vector<float>& thresholds);

// What radiance is shown as, 0 to 1 and before it is rounded to a code, and its code. A shader rounds its product with
// the exposure; NaN is 0. Computed in double.
double displayed(double radiance, float exposure);
uint32_t code_of(double radiance, float exposure);
double radiance_of(double displayed);  // at an exposure of 1; from 0 to 1

}  // namespace assay
