#pragma once
#include "harness/kernel.h"
#include "kernels/depth_gradients/layout.h"

namespace assay::depth_gradients {

// Of `gradients` as its unpacked fields.
Answer gradients_of(const Case&);
Unpack unpack_gradient();

// Of the plane that a pixel shows, exact: nothing where there is none, or no area.
std::optional<glm::dvec2> exact_gradient(const Case&, uint64_t pixel);

}  // namespace assay::depth_gradients
