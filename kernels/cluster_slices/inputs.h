// Cases for the slice look-up.
#pragma once
#include "harness/oracle.h"

namespace assay::cluster_slices {

Case typical(Extent);  // as many depths as pixels, from 1 m on
Inputs inputs();

}  // namespace assay::cluster_slices
