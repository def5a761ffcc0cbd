// A check's results as text for the log of a test.
#pragma once
#include <string>
#include <vector>

#include "harness/check/check.h"

namespace assay::tests {

void print_report(const std::vector<check::KernelResult>&);
// Why no variant of any kernel could run on this device; empty where one ran.
std::string skipped(const std::vector<check::KernelResult>&);
// Every failure with its replay command, and every complaint.
std::string complaints_of(const std::vector<check::KernelResult>&);

}  // namespace assay::tests
