#include "tests/check_report.h"

#include <fmt/format.h>

namespace assay::tests {

void print_report(const std::vector<check::KernelResult>& results) {
  for (const auto& kernel : results)
    for (const auto& v : kernel.variants) {
      fmt::print(
          "{} {}{}: {} cases, {} trials, {} violations, {} judged, {} undecided ({} of them in hard cases), {} "
          "flaky{}\n",
          kernel.name, v.name, v.baseline ? " (baseline)" : "", v.cases, v.trials, v.violations, v.judged, v.undecided,
          v.hard_undecided, v.flaky, v.skipped.empty() ? "" : ", skipped: " + v.skipped);
      for (const auto& b : v.bounds)
        fmt::print("  {}: worst {:g}, limit {:g}: {}\n", b.name, b.worst, b.limit, b.reason);
    }
}

std::string skipped(const std::vector<check::KernelResult>& results) {
  std::string why;
  for (const auto& kernel : results)
    for (const auto& variant : kernel.variants) {
      if (variant.skipped.empty()) return "";
      why += fmt::format("{} {}: {}\n", kernel.name, variant.name, variant.skipped);
    }
  return why;
}

std::string complaints_of(const std::vector<check::KernelResult>& results) {
  std::string text;
  for (const auto& kernel : results) {
    for (const auto& complaint : kernel.complaints) text += kernel.name + ": " + complaint + "\n";
    for (const auto& variant : kernel.variants)
      for (const auto& failure : variant.failures) text += failure.text + "\n  " + failure.replay + "\n";
  }
  return text;
}

}  // namespace assay::tests
