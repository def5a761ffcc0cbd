#pragma once
#include "harness/oracle.h"

namespace assay::command_visit {

Inputs inputs();
Case typical(Extent);

}  // namespace assay::command_visit
