// The slices of consecutive floats.
#pragma once
#include "harness/kernel.h"

namespace assay::cluster_slices {

Answer expected_slices(const Case&);

}  // namespace assay::cluster_slices
