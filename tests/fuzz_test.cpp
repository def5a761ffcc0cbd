// Random trials of every kernel; the seeds are fixed, so a failure repeats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "harness/check/check.h"
#include "tests/check_report.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

class Fuzz : public testing::TestWithParam<std::string> {};

TEST_P(Fuzz, Trials) {
  const check::Options options{.kernels = {GetParam()},
                               .variant = text_from("ASSAY_VARIANT"),
                               .trials = number_from("ASSAY_TRIALS", 100),
                               .hard = false};
  const auto results = check::check(device(), device_options(), options);
  print_report(results);
  if (const std::string why = skipped(results); !why.empty()) GTEST_SKIP() << why;
  for (const auto& kernel : results)
    for (const auto& [branch, times] : kernel.branches) fmt::print("branch {}: {}\n", branch, times);
  EXPECT_TRUE(check::passed(results)) << complaints_of(results);
}

INSTANTIATE_TEST_SUITE_P(Kernels, Fuzz, testing::ValuesIn(kernel_names()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace assay::tests
