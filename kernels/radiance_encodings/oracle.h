// What each colour's code must be.
#pragma once
#include "harness/kernel.h"

namespace assay::radiance_encodings {

// An encoding's name before "codes" and "decoded".
Answer round_trips(const Case&);
uint32_t encoding_of(const std::string& variant);
inline const std::vector<std::string> kEncodings = {"r11g11b10f", "rgb9e5", "rgba16f"};

}  // namespace assay::radiance_encodings
