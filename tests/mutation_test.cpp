// Every planted fault of every kernel must be found, and by the case that its description names.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "harness/check/check.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

constexpr size_t kFewestMutants = 6;  // of a kernel

class Mutation : public testing::TestWithParam<std::string> {};

TEST_P(Mutation, AllKilled) {
  const Kernel& kernel = kernel_named(GetParam());
  EXPECT_GE(kernel.mutants.size(), kFewestMutants);
  const auto results = check::mutate(device(), device_options(), {GetParam()}, 20);
  size_t killed = 0;
  for (const auto& m : results) {
    killed += !m.killed_by.empty();
    fmt::print("{} {} MUTANT_{} ({}): {}\n", m.kernel, m.variant, m.n, m.fault,
               m.killed_by.empty() ? "SURVIVED" : "killed by " + m.killed_by);
    EXPECT_EQ(m.killed_by, m.named) << m.variant << " MUTANT_" << m.n << ": " << m.fault;
  }
  fmt::print("mutation score of {}: {} of {}, {:.0f} %\n", GetParam(), killed, results.size(),
             results.empty() ? 0.0 : 100.0 * static_cast<double>(killed) / static_cast<double>(results.size()));
  EXPECT_FALSE(results.empty());
}

INSTANTIATE_TEST_SUITE_P(Kernels, Mutation, testing::ValuesIn(kernel_names()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace assay::tests
