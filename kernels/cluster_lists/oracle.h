// Lists from bits, cell by cell.
#pragma once
#include "harness/kernel.h"
#include "kernels/cluster_lists/layout.h"

namespace assay::cluster_lists {

Answer lists(const Case&);

}  // namespace assay::cluster_lists
