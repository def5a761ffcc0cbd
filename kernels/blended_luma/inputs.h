#pragma once
#include "harness/oracle.h"

namespace assay::blended_luma {

Inputs inputs();
Case typical(Extent);
Case in_frame(const FrameInputs&);

}  // namespace assay::blended_luma
