#pragma once
#include "harness/kernel.h"

namespace assay::attribute_interpolation {

Answer interpolate(const Case&);
// The name of a port's answer for one formula and encoding.
std::string answer_name(const std::string& port, const std::string& formula, uint32_t encoding);

}  // namespace assay::attribute_interpolation
