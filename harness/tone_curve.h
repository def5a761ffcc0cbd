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

// The code of radiance, whose product with the exposure a shader rounds; NaN is 0. Computed in double.
uint32_t code_of(double radiance, float exposure);

}  // namespace assay
