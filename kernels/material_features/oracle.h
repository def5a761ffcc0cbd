#pragma once
#include "harness/kernel.h"

namespace assay::material_features {

// A pixel's surface index names a surface, whose material index names a material, whose features are the pixel's. Where
// either index names nothing (no surface, or an index out of range) the pixel has no features.
Answer expected_features(const Case&);

}  // namespace assay::material_features
