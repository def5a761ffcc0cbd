// What each pixel may hold, from the same bytes that the draw reads.
#pragma once
#include "kernels/visibility/drawn.h"

namespace assay::visibility {

Answer rasterise(const Case&);

}  // namespace assay::visibility
