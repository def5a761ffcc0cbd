// Goals of kernels that report errors by class of inputs: every variant keeps to those that its table sets.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "harness/report/errors.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

TEST(Errors, GoalsAreKept) {
  size_t goals = 0;
  for (const Kernel& k : all_kernels())
    for (const Variant& v : k.variants) {
      if (!k.errors.figures) continue;
      // Other constants are other shapes of the same work; the bench prints the errors of all.
      const auto rows = report::measure_errors(*device(), k, v, device::combinations(v).front());
      for (const auto& row : rows)
        for (const Figure& f : row.figures) goals += f.limit != 0;
      EXPECT_EQ(fmt::format("{}", fmt::join(report::missed_goals(rows), "\n")), "");
    }
  EXPECT_GT(goals, 0u);
}

TEST(Errors, WhatIsPastItsGoalIsNamed) {
  const Kernel k = {.name = "kernel"};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<report::ErrorRow> rows = {
      {&k, nullptr, "variant", "class", {{"kept", 1, 1}, {"missed", 2, 1}, {"lost", nan, 1}, {"free", 9, 0}}}};
  EXPECT_EQ(report::missed_goals(rows),
            (std::vector<std::string>{"kernel variant, class class: missed is 2, the goal 1",
                                      "kernel variant, class class: lost is nan, the goal 1"}));
}

TEST(Errors, TheLeastErrorComesFirst) {
  const Kernel k = {.name = "kernel"};
  const std::vector<report::ErrorRow> rows = {{&k, nullptr, "rough", "a", {{"error", 3, 0}}},
                                              {&k, nullptr, "fine", "a", {{"error", 1, 0}}}};
  const auto table = report::error_table(rows, {{"fine", {1000, 20}}});
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"fine", "1.00 us", "20 B", "a", "1"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"rough", "-", "-", "a", "3"}));
}

}  // namespace
}  // namespace assay::tests
