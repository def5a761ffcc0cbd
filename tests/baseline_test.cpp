// Baselines: variants without a bound are timed and their errors shown, held to memory safety, and nobody's default.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/check/check.h"
#include "harness/report/bench.h"
#include "tests/check_report.h"
#include "tests/lowered.h"

namespace assay::tests {
namespace {

// One variant as it should be, the others baselines.
Kernel with_baselines(const std::vector<std::string>& names) {
  Kernel kernel = planted("check_faults");
  std::erase_if(kernel.variants, [&](const Variant& v) {
    return v.name != "correct" && std::ranges::find(names, v.name) == names.end();
  });
  for (Variant& v : kernel.variants) v.baseline = v.name != "correct";
  return kernel;
}

check::KernelResult checked(const Kernel& kernel) {
  check::Options options{.trials = 0, .fixtures = ""};
  options.failures = std::filesystem::temp_directory_path() / "assay-baseline";
  check::KernelResult result = check::check_kernel(device(), device_options(), options, kernel);
  std::filesystem::remove_all(options.failures);
  return result;
}

TEST(Baseline, IsHeldToMemorySafetyOnly) {
  const auto result = checked(
      with_baselines({"stray", "unwritten", "half_written", "touched", "wrong_value", "not_a_number", "repeated"}));
  EXPECT_TRUE(result.complaints.empty()) << complaints_of({result});
  for (const check::VariantResult& v : result.variants) {
    const bool unsafe = v.name == "stray" || v.name == "unwritten" || v.name == "half_written";
    EXPECT_EQ(v.violations, unsafe ? 1u : 0u) << v.name << "\n" << complaints_of({result});
  }
}

TEST(Baseline, ItsErrorsAndNansAreCounted) {
  const auto result = checked(with_baselines({"wrong_value", "not_a_number", "repeated"}));
  EXPECT_TRUE(check::passed({result})) << complaints_of({result});
  for (const check::VariantResult& v : result.variants) {
    EXPECT_EQ(v.wrong, v.name == "correct" ? 0u : 1u) << v.name;
    EXPECT_EQ(v.nans, v.name == "not_a_number" ? 1u : 0u) << v.name;
    EXPECT_EQ(std::isinf(v.bounds.at(0).worst), v.name == "wrong_value" || v.name == "not_a_number") << v.name;
  }
}

TEST(Baseline, IsNobodysDefault) {
  Kernel kernel = with_baselines({"wrong_value"});
  kernel.default_variant = "wrong_value";
  const auto result = checked(kernel);
  EXPECT_EQ(result.complaints, std::vector<std::string>{"the default variant, wrong_value, is a baseline"});
  EXPECT_FALSE(check::passed({result}));
}

TEST(Baseline, MutantsCountWhereSomethingNotices) {
  Kernel kernel = with_baselines({"reversed"});
  const auto shared = check::mutate_kernel(device(), device_options(), kernel, 0);
  ASSERT_EQ(shared.size(), kernel.mutants.size());
  for (const auto& m : shared) EXPECT_EQ(m.variant, "correct");

  std::erase_if(kernel.variants, [](const Variant& v) { return !v.baseline; });  // the file is now a baseline's alone
  const auto alone = check::mutate_kernel(device(), device_options(), kernel, 0);
  ASSERT_EQ(alone.size(), kernel.mutants.size());
  for (const auto& m : alone) EXPECT_EQ(m.killed_by, m.n == 4 ? "marked" : "") << m.n << ": only 4 writes outside";
}

TEST(Baseline, IsTimedHoweverWrongUnlessUnsafe) {
  const Kernel kernel = with_baselines({"stray", "unwritten", "wrong_value", "not_a_number"});
  const check::Prepared prepared =
      check::prepare(kernel, kernel.inputs.hard.at(0).make(), device::info(*device()).traits);
  for (const Variant& v : kernel.variants) {
    const report::Verified verified =
        report::verify(*device(), {.kernel = &kernel, .variant = &v, .constants = {}, .extent = {}}, prepared);
    const bool unsafe = v.name == "stray" || v.name == "unwritten";
    EXPECT_EQ(verified.broken, unsafe) << v.name << " " << verified.refused;
    // What was not written still holds poison, a NaN.
    EXPECT_EQ(verified.nans, v.name == "not_a_number" || v.name == "unwritten" ? 1u : 0u) << v.name;
    EXPECT_EQ(verified.bounds.at(0).name, "ulps(pairs)");
  }
}

TEST(Baseline, TablesShowItsErrors) {
  const Kernel kernel = with_baselines({"not_a_number"});
  report::Row row{
      .entry = {
          .kernel = &kernel, .variant = &variant_of(kernel, "not_a_number"), .constants = {}, .extent = {10, 10}}};
  row.verified = {.bounds = {{"ulps(pairs)", 1, INFINITY, "one rounding"}}, .judged = 200, .violations = 1, .nans = 1};
  row.cold = row.hot = {{.gpu_ns = 1000, .cpu_ns = 1000, .wall_ns = 1000}};
  report::Run run;
  run.rows.push_back(row);
  for (const std::string& text : {report::as_text(report::speed_table(run, device::info(*device()))),
                                  report::as_text(report::speed_against_error_table(run, kernel))}) {
    EXPECT_NE(text.find("baseline, 1 of 200 wrong, 1 NaN"), std::string::npos) << text;
    EXPECT_NE(text.find("inf of 1 (ulps(pairs))"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace assay::tests
