// Passes: compute, indirect, repeated, guards, second view formats.
#include <gtest/gtest.h>

#include "tests/lowered.h"
#include "tests/planted/device_copy/layout.h"

namespace assay::tests {
namespace {

using device_copy::CopyParams;
using device_copy::Pair;

Case copy_case(const std::string& variant, uint32_t count) {
  Case c = {.name = "copy"};
  c.extent = {5, 3};
  c.set_params(CopyParams{count, 10});
  std::vector<Pair> pairs(count);
  for (uint32_t i = 0; i < count; ++i) pairs[i] = {i, vec3(static_cast<float>(i), 2, 3), {4, 5}};
  if (variant != "rows") c.set_input("pairs", pairs);
  c.set_input("arguments", std::vector<DispatchArgs>{{1, 1, 1}, {2, 2, 2}, {0, 1, 1}});
  return c;
}
Ran run_copy(const std::string& variant, uint32_t count, std::map<std::string, uint32_t> constants = {}) {
  return run_variant(*device(), planted("device_copy"), variant, copy_case(variant, count), std::move(constants));
}

TEST(Passes, ConstantsAreSetByName) {
  for (const uint32_t count : {0u, 1u, 63u, 64u, 65u, 1000u}) {
    const Ran r = run_copy("direct", count, {{"SCALE", 3}, {"GROUP", 32}});
    const auto copies = read<Pair>(*device(), r, "copies");
    ASSERT_EQ(copies.size(), count);
    for (uint32_t i = 0; i < count; ++i) {
      EXPECT_EQ(copies[i].key, i * 3 + 10);
      EXPECT_EQ(copies[i].place, vec3(static_cast<float>(i), 2, 3));
      EXPECT_EQ(copies[i].weights[1], static_cast<float>(device::info(*device()).traits.subgroup_width));
    }
    for (const uint32_t word : values<uint32_t>(device::read_guard(*device(), *r.ports.at("copies"))))
      ASSERT_EQ(word, kPoison);
  }
}

TEST(Passes, TimesAreMeasured) {
  const Ran r = run_copy("direct", 1000);
  ASSERT_EQ(r.timing.stamps.size(), 2u);
  EXPECT_EQ(r.timing.stamps[0].label, "start");
  EXPECT_EQ(r.timing.stamps[0].time_ns, 0);
  EXPECT_GT(r.timing.stamps[1].time_ns, 0);
  EXPECT_GT(r.timing.cpu_ns, 0);
  EXPECT_GT(r.timing.wall_ns, 0);
}

TEST(Passes, AStrayWriteLandsInTheGuard) {
  const Ran r = run_copy("stray", 70);
  const auto guard = values<uint32_t>(device::read_guard(*device(), *r.ports.at("copies")));
  EXPECT_EQ(guard.size() * 4, device::kGuardBytes);
  EXPECT_EQ(guard[0], 0xbadu);
  EXPECT_EQ(guard[1], kPoison);
}

TEST(Passes, ARepeatedPassRunsOnceARow) {
  const Ran r = run_copy("rows", 1);
  const auto rows = read<uint32_t>(*device(), r, "rows");
  EXPECT_EQ(rows[0], 7u + 1);
  EXPECT_EQ(rows[1], 7u + 8);
  EXPECT_EQ(rows[2], 7u);
  EXPECT_EQ(rows[3], 7u);
  std::vector<device::Command::Kind> kinds;
  for (const device::Command& c : r.commands) kinds.push_back(c.kind);
  using enum device::Command::Kind;
  EXPECT_EQ(kinds, (std::vector{timestamp, clear, barrier, dispatch, dispatch, dispatch, timestamp}));
  EXPECT_EQ(r.commands[4].label, "device_copy.rows row.comp row 1");
}

TEST(Passes, ADispatchOfNoGroupsIsLeftOut) { EXPECT_EQ(run_copy("empty", 0).commands.size(), 2u); }

TEST(Passes, TooManyGroupsAreRefused) {
  try {
    run_copy("huge", 1);
    FAIL();
  } catch (const device::Error& e) {
    EXPECT_NE(std::string(e.what()).find("device_copy.huge copy.comp: 2147483648 x 1 x 1 groups"), std::string::npos)
        << e.what();
  }
}

TEST(Passes, AnUnknownConstantIsRefused) { EXPECT_THROW(run_copy("direct", 1, {{"SPEED", 3}}), std::logic_error); }

TEST(Passes, WritesAPackedFormatThroughASecondView) {
  const Ran r = run_copy("image", 1);
  const auto texels = read<uint32_t>(*device(), r, "stored");
  for (uint32_t y = 0; y < 3; ++y)
    for (uint32_t x = 0; x < 5; ++x) EXPECT_EQ(texels[y * 5 + x], x + 1000 * y);
}

TEST(Passes, UsesAreReflected) {
  const Ran r = run_copy("direct", 10);
  ASSERT_EQ(r.commands.size(), 3u);
  for (const device::Use& u : r.commands[1].uses) {
    EXPECT_EQ(u.reads, u.port != "copies") << u.port;
    EXPECT_EQ(u.writes, u.port == "copies") << u.port;
    EXPECT_EQ(u.scope, device::kCompute);
  }
  EXPECT_EQ(r.commands[1].uses.size(), 3u);
}

}  // namespace
}  // namespace assay::tests
