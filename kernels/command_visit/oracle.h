#pragma once
#include "harness/kernel.h"
#include "kernels/command_visit/layout.h"

namespace assay::command_visit {

uint64_t visible(const Case&);  // slots that are run

// Every valid entry of a commanded wave is visited once a command, if there are groups to do it.
Answer visit(const Case&);

}  // namespace assay::command_visit
