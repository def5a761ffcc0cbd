// Which rectangle each particle must get.
#pragma once
#include "harness/kernel.h"
#include "kernels/particle_rects/layout.h"

namespace assay::particle_rects {

uint32_t particle_count(const Case&);

uint32_t wanted_size(const RectParams&, const ParticleRecord&);

// Exact: one particle after another.
Answer allocation(const Case&);

}  // namespace assay::particle_rects
