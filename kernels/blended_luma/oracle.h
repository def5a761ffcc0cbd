#pragma once
#include "harness/oracle.h"

namespace assay::blended_luma {

Answer lumas(const Case&);

}  // namespace assay::blended_luma
