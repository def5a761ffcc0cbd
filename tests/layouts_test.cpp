// Shaders and descriptions agree: reflected layouts, and the cost model's bytes with what the ports hold.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/check/judge.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

class Layouts : public testing::TestWithParam<std::string> {};

TEST_P(Layouts, EveryVariantsShadersMatchItsPorts) {
  const Kernel& kernel = kernel_named(GetParam());
  for (const Variant& variant : kernel.variants) {
    const auto errors = device::layout_errors(kernel, variant);
    EXPECT_TRUE(errors.empty()) << variant.name << ": " << fmt::format("{}", fmt::join(errors, "\n"));
  }
}

uint64_t bytes_held(const Port& port, const Case& c) {
  if (port.kind == PortKind::textures) {
    uint64_t bytes = 0;
    const auto it = c.textures.find(port.name);
    if (it != c.textures.end())
      for (const Texture& t : it->second) bytes += t.bytes.size();
    return bytes;
  }
  const uint64_t count =
      port.kind == PortKind::buffer ? port.count(c) : pixel_count(port.extent ? port.extent(c) : c.extent);
  return count * check::layout_of_port(port).stride;
}

std::set<std::string> ports_used(const Kernel& kernel, const Variant& variant, const Case& c) {
  const device::Plan plan{.kernel = &kernel, .variant = &variant};
  const device::Ports ports = device::make_ports(*device(), kernel, c, {}, &variant);
  std::set<std::string> used;
  for (const device::Command& command : device::lower(*device(), plan, c, ports))
    for (const device::Use& use : command.uses) used.insert(use.port);
  return used;
}

void expect_cost(const Kernel& kernel, const Variant& variant, const Case& c) {
  const auto used = ports_used(kernel, variant, c);
  uint64_t read = 0, written = 0;
  for (const Port& port : kernel.ports) {
    if (!used.contains(port.name)) continue;
    if (port.use != Use::writes) read += bytes_held(port, c);
    if (port.use != Use::reads) written += bytes_held(port, c);
  }
  const Cost cost = cost_of(kernel, variant, c);
  EXPECT_EQ(cost.bytes_read, read) << variant.name;
  EXPECT_EQ(cost.bytes_written, written) << variant.name;
  EXPECT_GT(cost.operations, 0u) << variant.name;
}

// Of the ports that the commands touch on the typical case, of the default variant and of those with a cost of their
// own: a draw of nothing binds nothing. Updated ports are read and written.
TEST_P(Layouts, CostIsWhatThePortsHold) {
  const Kernel& kernel = kernel_named(GetParam());
  const auto variant = std::ranges::find(kernel.variants, kernel.default_variant, &Variant::name);
  ASSERT_NE(variant, kernel.variants.end()) << "no default variant " << kernel.default_variant;
  ASSERT_FALSE(kernel.extents.empty());
  const Case c = kernel.typical(kernel.extents[0]);
  for (const Variant& v : kernel.variants)
    if ((v.name == kernel.default_variant || v.cost) && device::missing(device::info(*device()), v).empty())
      expect_cost(kernel, v, c);
}

TEST_P(Layouts, DescriptionIsComplete) {
  const Kernel& kernel = kernel_named(GetParam());
  EXPECT_FALSE(kernel.source.empty());
  for (const Variant& variant : kernel.variants)
    for (const Bound& bound : bounds_of(kernel, variant)) EXPECT_FALSE(bound.reason.empty()) << check::name_of(bound);
  for (const HardCase& hard : kernel.inputs.hard) EXPECT_FALSE(hard.why.empty()) << hard.name;
  for (const Mutant& mutant : kernel.mutants)
    EXPECT_NE(std::ranges::find(kernel.inputs.hard, mutant.killed_by, &HardCase::name), kernel.inputs.hard.end())
        << "MUTANT_" << mutant.n << " names no hard case: " << mutant.killed_by;
}

INSTANTIATE_TEST_SUITE_P(Kernels, Layouts, testing::ValuesIn(kernel_names()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace assay::tests
