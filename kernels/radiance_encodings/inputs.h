// Colours to be stored.
#pragma once
#include "harness/kernel.h"
#include "harness/oracle.h"
#include "kernels/radiance_encodings/layout.h"

namespace assay::radiance_encodings {

Case typical(Extent);
Inputs inputs();
ErrorTable errors();

}  // namespace assay::radiance_encodings
