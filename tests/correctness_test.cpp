// Every kernel's hard cases in every variant. Nightly adds the large ones. ASSAY_EXTENT_LIMIT leaves out those over so
// many pixels a side, for runs that repeat on many configurations, ASSAY_VARIANT all variants but one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "harness/check/check.h"
#include "tests/check_report.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

void expect_hard_cases_pass(const std::string& kernel, bool nightly) {
  check::Options options{.kernels = {kernel}, .variant = text_from("ASSAY_VARIANT"), .trials = 0, .nightly = nightly};
  options.extent_limit = number_from("ASSAY_EXTENT_LIMIT", 0);
  const auto results = check::check(device(), device_options(), options);
  print_report(results);
  if (const std::string why = skipped(results); !why.empty()) GTEST_SKIP() << why;
  EXPECT_TRUE(check::passed(results)) << complaints_of(results);
}

class Correctness : public testing::TestWithParam<std::string> {};
TEST_P(Correctness, HardCases) { expect_hard_cases_pass(GetParam(), false); }
INSTANTIATE_TEST_SUITE_P(Kernels, Correctness, testing::ValuesIn(kernel_names()),
                         [](const auto& p) { return p.param; });

class Nightly : public testing::TestWithParam<std::string> {};
TEST_P(Nightly, HardCases) { expect_hard_cases_pass(GetParam(), true); }
INSTANTIATE_TEST_SUITE_P(Kernels, Nightly, testing::ValuesIn(kernel_names()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace assay::tests
