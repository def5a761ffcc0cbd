// Cases for the allocation.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/particle_rects/layout.h"

namespace assay::particle_rects {

// As many puffs as the picture has thousands of pixels, over a half of them where they were.
Case typical(Extent);
Inputs inputs();
std::vector<Mutant> mutants();
Case in_frame(const FrameInputs&);

// For hard.cpp. `previous` may be shorter: then 0.
Case case_of(const RectParams&, const std::vector<ParticleRecord>&, std::vector<uint32_t> previous = {});
// A picture of 90 degrees along -z, `width` pixels across.
RectParams view(const ParticleAtlas&, double width = 1000);
std::vector<HardCase> hard_cases();

}  // namespace assay::particle_rects
