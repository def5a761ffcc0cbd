#pragma once
#include "harness/kernel.h"
#include "kernels/shadow_lookup/layout.h"

namespace assay::shadow_lookup {

// The share of its light that each receiver gets: "pcf_2x2", "pcf_3x3", "pcf_7x7". A receiver is undecided where
// rounding may tip a comparison or a choice: where the share is open by more than a hundredth.
Answer expected_shares(const Case&);

}  // namespace assay::shadow_lookup
