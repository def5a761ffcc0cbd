#pragma once
#include "kernels/attribute_interpolation/scene_builder.h"

namespace assay::attribute_interpolation {

Inputs inputs();
std::vector<HardCase> hard_cases();
std::vector<HardCase> hostile_cases();
Case published_vectors();  // fixtures/attribute_interpolation; throws where the oracle does not agree with their
                           // answers
Case typical(Extent);
ErrorTable error_table();
Case frame(const FrameInputs&);

}  // namespace assay::attribute_interpolation
