// Missing barriers: planted in made-up commands, and in a real frame's by taking barriers out.
#include "harness/frame/hazards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "harness/frame/frame.h"
#include "harness/frame/record.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

using device::barrier;
using device::Command;
using frame::find_hazards;
using frame::HazardKind;

struct Planted {
  device::Owned first = device::make_buffer(*device(), "first", 256),
                second = device::make_buffer(*device(), "second", 256);

  Command touch(const std::string& label, bool reads, bool writes, uint32_t scope = device::kCompute,
                uint64_t offset = 0, uint64_t bytes = 256) const {
    return {.kind = Command::Kind::dispatch,
            .label = label,
            .uses = {{.port = "port_of_" + label,
                      .resource = first.get(),
                      .offset = offset,
                      .bytes = bytes,
                      .reads = reads,
                      .writes = writes,
                      .scope = scope}}};
  }
  Command read(const std::string& label, uint32_t scope = device::kCompute) const {
    return touch(label, true, false, scope);
  }
  Command write(const std::string& label, uint32_t scope = device::kCompute) const {
    return touch(label, false, true, scope);
  }
};

std::vector<HazardKind> kinds(std::vector<Command> commands) {
  std::vector<HazardKind> found;
  for (const auto& h : find_hazards(commands)) found.push_back(h.kind);
  return found;
}
using Kinds = std::vector<HazardKind>;

TEST(Hazards, EachKindIsFoundAndABarrierCuresIt) {
  const Planted p;
  EXPECT_EQ(kinds({p.write("a"), p.read("b")}), Kinds{HazardKind::read_after_write});
  EXPECT_EQ(kinds({p.read("a"), p.write("b")}), Kinds{HazardKind::write_after_read});
  EXPECT_EQ(kinds({p.write("a"), p.write("b")}), Kinds{HazardKind::write_after_write});
  EXPECT_EQ(kinds({p.touch("a", true, true), p.touch("b", true, true)}), Kinds{HazardKind::read_after_write});
  EXPECT_EQ(kinds({p.read("a"), p.read("b")}), Kinds{});
  EXPECT_EQ(kinds({p.write("a"), barrier(), p.read("b"), barrier(), p.write("c")}), Kinds{});
}

TEST(Hazards, ABarrierBeforeOrBehindBothDoesNotHelp) {
  const Planted p;
  EXPECT_EQ(kinds({barrier(), p.write("a"), p.read("b"), barrier()}), Kinds{HazardKind::read_after_write});
  EXPECT_EQ(kinds({p.write("a"), device::timestamp("t"), p.read("b")}), Kinds{HazardKind::read_after_write});
}

TEST(Hazards, ScopesMustFit) {
  const Planted p;
  using namespace device;
  const auto between = [&](uint32_t from, uint32_t to) {
    return kinds({p.write("a", kAttachment), barrier(from, to), p.read("b", kIndirect)});
  };
  EXPECT_EQ(between(kAttachment, kIndirect), Kinds{});
  EXPECT_EQ(between(kAttachment | kCompute, kIndirect | kHost), Kinds{});
  EXPECT_EQ(between(kCompute, kIndirect), Kinds{HazardKind::read_after_write});
  EXPECT_EQ(between(kAttachment, kCompute), Kinds{HazardKind::read_after_write});
  // A use in two scopes waits for both.
  EXPECT_EQ(kinds({p.write("a"), barrier(kCompute, kCompute), p.read("b", kCompute | kIndirect)}),
            Kinds{HazardKind::read_after_write});
}

TEST(Hazards, BarriersChain) {
  const Planted p;
  using namespace device;
  EXPECT_EQ(
      kinds({p.write("a", kAttachment), barrier(kAttachment, kTransfer), barrier(kTransfer, kCompute), p.read("b")}),
      Kinds{});
  EXPECT_EQ(kinds({p.write("a", kAttachment), barrier(kAttachment, kTransfer), barrier(kHost, kCompute), p.read("b")}),
            Kinds{HazardKind::read_after_write});
  EXPECT_EQ(
      kinds({p.write("a", kAttachment), barrier(kTransfer, kCompute), barrier(kAttachment, kTransfer), p.read("b")}),
      Kinds{HazardKind::read_after_write});
}

TEST(Hazards, RangesAndResourcesThatDoNotMeetAreFree) {
  const Planted p;
  EXPECT_EQ(kinds({p.touch("a", false, true, device::kCompute, 0, 128),
                   p.touch("b", true, false, device::kCompute, 128, 128)}),
            Kinds{});
  EXPECT_EQ(kinds({p.touch("a", false, true, device::kCompute, 0, 129),
                   p.touch("b", true, false, device::kCompute, 128, 128)}),
            Kinds{HazardKind::read_after_write});
  Command other = p.read("b");
  other.uses[0].resource = p.second.get();
  EXPECT_EQ(kinds({p.write("a"), other}), Kinds{});
}

TEST(Hazards, OnlyTheRowsOfOneRepeatedPassMayMeet) {
  const Planted p;
  EXPECT_EQ(kinds({p.write("k.v s.comp row 0"), p.write("k.v s.comp row 1")}), Kinds{});
  EXPECT_EQ(kinds({p.write("k.v s.comp row 0"), p.write("k.v t.comp row 1")}), Kinds{HazardKind::write_after_write});
  EXPECT_EQ(kinds({p.write("k.v s.comp"), p.write("k.v s.comp")}), Kinds{HazardKind::write_after_write});
}

TEST(Hazards, TheErrorNamesBothCommandsThePortsAndTheKind) {
  const Planted p;
  const std::vector<Command> commands = {p.write("maker", device::kAttachment), p.read("reader", device::kIndirect)};
  try {
    frame::require_no_hazards(commands);
    FAIL();
  } catch (const std::logic_error& e) {
    EXPECT_STREQ(e.what(),
                 "read after write of first: 'maker' (port port_of_maker) then 'reader' (port port_of_reader), and no "
                 "barrier from attachment to indirect between");
  }
}

// ---- A real frame's commands
// -------------------------------------------------------------------------------------------

// Few enough kernels that every barrier between them can be told.
const std::vector<Kernel>& short_chain() {
  static const std::vector<Kernel> chain = {kernel_named("debug_view"), kernel_named("material_features"),
                                            kernel_named("tile_classification"), kernel_named("visibility")};
  return chain;
}

struct Recorded {
  scene::Scene scene = scene::small();
  scene::Gathered gathered = scene::gather(scene, scene::default_camera(scene), {160, 96});
  frame::Graph graph = frame::build_graph({.kernels = short_chain(),
                                           .view = {.extent = {160, 96}, .scene = gathered.counts, .view = 3},
                                           .scene = frame::scene_bytes(gathered),
                                           .goals = {"debug_view.image", frame::kStatistics}});
  frame::Allocated allocated = frame::allocate(*device(), graph, gathered);
  std::vector<Command> commands = frame::record(*device(), graph, allocated);
};

TEST(Hazards, TheFrameHasNone) {
  const Recorded r;
  for (const auto& h : find_hazards(r.commands)) ADD_FAILURE() << to_text(h);
  EXPECT_GT(r.commands.size(), 10u);
}

// The barriers that the graph placed; those within a kernel join all scopes.
std::vector<size_t> own_barriers(const std::vector<Command>& commands) {
  std::vector<size_t> found;
  for (size_t i = 0; i < commands.size(); ++i) {
    const Command& c = commands[i];
    if (c.kind == Command::Kind::barrier && !(c.from == device::kAll && c.to == device::kAll)) found.push_back(i);
  }
  return found;
}

TEST(Hazards, ABarrierTakenOutOfTheFrameOrOfWrongScopesIsMissed) {
  const Recorded r;
  const auto own = own_barriers(r.commands);
  ASSERT_EQ(own.size(), 3u);  // visibility to features, features to masks, masks to the picture
  // The third is there for what the kernels declare. What they really do, a barrier within debug_view covers too.
  for (const size_t i : {own[0], own[1]}) {
    std::vector<Command> without = r.commands;
    without.erase(without.begin() + static_cast<ptrdiff_t>(i));
    EXPECT_FALSE(find_hazards(without).empty()) << "barrier " << i;
    std::vector<Command> wrong = r.commands;
    wrong[i].from = device::kHost;
    EXPECT_FALSE(find_hazards(wrong).empty()) << "barrier " << i << " from the host";
    wrong[i] = r.commands[i];
    wrong[i].to = device::kHost;
    EXPECT_FALSE(find_hazards(wrong).empty()) << "barrier " << i << " to the host";
  }
}

TEST(Hazards, WithNoBarrierFromAPlaceOnSomethingIsMissedAcrossIt) {
  const Recorded r;
  for (const size_t i : own_barriers(r.commands)) {
    std::vector<Command> cut(r.commands.begin(), r.commands.begin() + static_cast<ptrdiff_t>(i));
    std::set<std::string> before;
    for (const Command& c : cut) before.insert(c.label);
    for (size_t k = i; k < r.commands.size(); ++k)
      if (r.commands[k].kind != Command::Kind::barrier) cut.push_back(r.commands[k]);
    const auto hazards = find_hazards(cut);
    EXPECT_TRUE(std::ranges::any_of(
        hazards, [&](const frame::Hazard& h) { return before.contains(h.first) && !before.contains(h.second); }))
        << "barrier " << i;
  }
}

TEST(Hazards, WithoutAnyBarrierEveryStepOfTheFrameIsNamed) {
  const Recorded r;
  std::vector<Command> bare;
  for (const Command& c : r.commands)
    if (c.kind != Command::Kind::barrier) bare.push_back(c);
  std::set<std::string> resources;
  for (const auto& h : find_hazards(bare)) resources.insert(h.resource);
  for (const char* name : {"visibility.visibility", "material_features.features", "tile_classification.masks",
                           "tile_classification.workload_counts", "tile_classification.workload_args"})
    EXPECT_TRUE(resources.contains(name)) << name;
  EXPECT_THROW(frame::require_no_hazards(bare), std::logic_error);
}

}  // namespace
}  // namespace assay::tests
