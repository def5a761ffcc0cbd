// Cases for the visibility draw.
#pragma once
#include "kernels/visibility/scene_builder.h"

namespace assay::visibility {

// About 60,000 triangles from under a pixel to the whole screen, some masked, instanced, mirrored; no hard ones.
Case typical(Extent);
// The parameters alone: a frame has a producer for everything else.
Case frame(const FrameInputs&);
Inputs inputs();
std::vector<HardCase> hard_cases();
std::vector<Mutant> mutants();

}  // namespace assay::visibility
