// The frame's graph, from kernels that exist only as descriptions.
#include "harness/frame/graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "harness/frame/explain.h"

namespace assay::tests {
namespace {

using frame::build_graph;
using frame::Graph;

Kernel kernel(const std::string& name, std::vector<Port> ports) {
  Kernel k = {.name = name, .default_variant = "plain", .ports = std::move(ports)};
  k.variants = {{.name = "plain", .passes = {Dispatch{"main.comp", [](const Case&) { return Groups{1}; }}}}};
  k.frame = [](const FrameInputs& f) { return Case{.name = "frame", .extent = f.extent}; };
  return k;
}
Port in(const std::string& name, std::vector<std::string> producers) {
  return reads<uint32_t>(name, pixels, std::move(producers));
}
Port out(const std::string& name) { return writes<uint32_t>(name, pixels); }
Port changes(const std::string& name, std::vector<std::string> producers) {
  return updates<uint32_t>(name, pixels, std::move(producers));
}

std::vector<std::string> all_ports(const Kernel& k, const std::string&) {
  std::vector<std::string> names;
  for (const Port& p : k.ports) names.push_back(p.name);
  return names;
}

Graph graph_of(const std::vector<Kernel>& kernels, std::vector<std::string> goals,
               std::map<std::string, uint64_t> scene = {}) {
  return build_graph({.kernels = kernels,
                      .view = {.extent = {10, 10}},
                      .scene = std::move(scene),
                      .goals = std::move(goals),
                      .shader_ports = all_ports});
}
std::vector<std::string> names(const Graph& g) {
  std::vector<std::string> found;
  for (const frame::Node& n : g.nodes) found.push_back(n.kernel->name);
  return found;
}
std::string reason(const Graph& g, const std::string& kernel_name) {
  for (const frame::LeftOut& l : g.left_out)
    if (l.kernel == kernel_name) return l.reason;
  return "not left out";
}
template <class E>
std::string refusal(const std::vector<Kernel>& kernels, std::vector<std::string> goals) {
  try {
    graph_of(kernels, std::move(goals));
  } catch (const E& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Graph, ProducersComeFirstWhateverTheirNames) {
  const std::vector<Kernel> k = {kernel("a", {in("x", {"b.x"}), out("y")}),
                                 kernel("b", {in("s", {"scene.s"}), out("x")})};
  const Graph g = graph_of(k, {"a.y"}, {{"scene.s", 400}});
  EXPECT_EQ(names(g), (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(g.resources.at(frame::resource_named(g, "b.x")).bytes, 400u);
  EXPECT_EQ(frame::readers_of(g, frame::resource_named(g, "b.x")), std::vector<std::string>{"a"});
}

TEST(Graph, TheLatestProducerThatIsThereWins) {
  const std::vector<Kernel> without = {kernel("early", {out("x")}),
                                       kernel("reader", {in("x", {"late.x", "early.x"}), out("y")})};
  EXPECT_EQ(names(graph_of(without, {"reader.y"})), (std::vector<std::string>{"early", "reader"}));
  std::vector<Kernel> with = without;
  with.push_back(kernel("late", {changes("x", {"early.x"})}));
  EXPECT_EQ(names(graph_of(with, {"reader.y"})), (std::vector<std::string>{"early", "late", "reader"}));
}

TEST(Graph, WhatNobodyNeedsIsLeftOut) {
  const std::vector<Kernel> k = {kernel("needed", {out("x")}), kernel("spare", {in("x", {"needed.x"}), out("y")}),
                                 kernel("orphan", {in("z", {"nobody.z"}), out("w")})};
  const Graph g = graph_of(k, {"needed.x"});
  EXPECT_EQ(names(g), std::vector<std::string>{"needed"});
  EXPECT_EQ(reason(g, "spare"), "nothing that is asked for needs it");
  EXPECT_EQ(reason(g, "orphan"), "nothing produces nobody.z for its port z");
  EXPECT_EQ(frame::resource_named(g, "spare.y"), frame::kNobody);
}

TEST(Graph, AKernelWithoutWorkIsAbsentAndItsReadersFallBack) {
  std::vector<Kernel> k = {kernel("early", {out("x")}), kernel("late", {changes("x", {"early.x"})}),
                           kernel("reader", {in("x", {"late.x", "early.x"}), out("y")})};
  k[1].variants[0].passes = {Dispatch{"main.comp", [](const Case&) { return Groups{0}; }}};
  const Graph g = graph_of(k, {"reader.y"});
  EXPECT_EQ(names(g), (std::vector<std::string>{"early", "reader"}));
  EXPECT_EQ(reason(g, "late"), "this frame has no work for it");
}

TEST(Graph, AnUpdateSharesMemoryAndWaitsForReadersOfTheOldVersion) {
  const std::vector<Kernel> k = {kernel("maker", {out("x")}), kernel("updater", {changes("x", {"maker.x"})}),
                                 kernel("watcher", {in("x", {"maker.x"}), out("y")}),
                                 kernel("user", {in("x", {"updater.x"}), in("y", {"watcher.y"}), out("z")})};
  const Graph g = graph_of(k, {"user.z"});
  EXPECT_EQ(names(g), (std::vector<std::string>{"maker", "watcher", "updater", "user"}));
  const size_t first = frame::resource_named(g, "maker.x"), second = frame::resource_named(g, "updater.x");
  EXPECT_EQ(g.resources[second].memory, first);
  const auto e = frame::explain(g, {});
  EXPECT_EQ(frame::total_bytes(e), 3 * 400u);  // x, y and z, the new version of x free of charge
}

TEST(Graph, BarriersJoinTheDeclaredUses) {
  const std::vector<Kernel> k = {kernel("a", {out("x")}), kernel("b", {in("x", {"a.x"}), out("y")}),
                                 kernel("c", {in("x", {"a.x"}), in("y", {"b.y"}), out("z")}),
                                 kernel("d", {out("other")})};
  const Graph g = graph_of(k, {"c.z", "d.other"});
  ASSERT_EQ(g.nodes.size(), 4u);
  EXPECT_FALSE(g.nodes[0].barrier);
  EXPECT_EQ(g.nodes[1].barrier, (std::pair<uint32_t, uint32_t>{device::kCompute, device::kCompute}));
  EXPECT_EQ(g.nodes[2].barrier, (std::pair<uint32_t, uint32_t>{device::kCompute, device::kCompute}));
  EXPECT_FALSE(g.nodes[3].barrier);  // it shares nothing with the others
}

TEST(Graph, AnIndirectReaderIsWaitedForAsSuch) {
  std::vector<Kernel> k = {kernel("a", {writes<DispatchArgs>("args", fixed(1))}),
                           kernel("b", {reads<DispatchArgs>("args", fixed(1), {"a.args"}), out("y")})};
  k[1].variants[0].passes = {Dispatch{.shader = "main.comp", .indirect = "args"}};
  const Graph g =
      build_graph({.kernels = k, .goals = {"b.y"}, .shader_ports = [](const Kernel& of, const std::string&) {
                     return std::vector<std::string>{of.name == "a" ? "args" : "y"};
                   }});
  EXPECT_EQ(g.nodes.at(1).barrier, (std::pair<uint32_t, uint32_t>{device::kCompute, device::kIndirect}));
}

TEST(Graph, TwoUpdatersOfOneVersionAreRefusedByName) {
  const std::vector<Kernel> k = {kernel("maker", {out("x")}), kernel("left", {changes("x", {"maker.x"})}),
                                 kernel("right", {changes("x", {"maker.x"})})};
  const std::string text = refusal<std::runtime_error>(k, {"left.x", "right.x"});
  EXPECT_EQ(text, "left and right both update maker.x: one of them must read what the other makes");
}

TEST(Graph, ACycleIsRefusedByName) {
  const std::vector<Kernel> k = {kernel("hen", {in("x", {"egg.x"}), out("y")}),
                                 kernel("egg", {in("y", {"hen.y"}), out("x")})};
  const std::string text = refusal<std::runtime_error>(k, {"hen.y"});
  EXPECT_EQ(text, "a cycle of kernels: hen needs egg needs hen");
}

TEST(Graph, AGoalThatNothingProducesIsRefused) {
  const std::vector<Kernel> k = {kernel("a", {in("x", {"nobody.x"}), out("y")})};
  EXPECT_EQ(refusal<std::invalid_argument>(k, {"a.y"}),
            "nothing produces a.y; it is left out: nothing produces nobody.x for its port x");
  EXPECT_EQ(refusal<std::invalid_argument>(k, {"b.y"}), "nothing produces b.y");
}

TEST(Graph, AGoalThatIsOverwrittenIsRefused) {
  const std::vector<Kernel> k = {kernel("maker", {out("x")}), kernel("updater", {changes("x", {"maker.x"})})};
  EXPECT_EQ(refusal<std::invalid_argument>(k, {"maker.x", "updater.x"}),
            "maker.x is overwritten by updater; ask for what that makes");
}

TEST(Graph, AnUnknownVariantIsRefused) {
  const std::vector<Kernel> k = {kernel("a", {out("x")})};
  const auto build = [&](const std::map<std::string, std::string>& variants) {
    build_graph({.kernels = k, .variants = variants, .goals = {"a.x"}, .shader_ports = all_ports});
  };
  EXPECT_NO_THROW(build({{"a", "plain"}}));
  EXPECT_THROW(build({{"a", "fancy"}}), std::invalid_argument);
  EXPECT_THROW(build({{"b", "plain"}}), std::invalid_argument);
}

// A pass without groups asks for nothing: what only it reads is not made.
TEST(Graph, WhatOnlyAPassThatDoesNotRunReadsIsNotMade) {
  for (const bool shown : {false, true}) {
    std::vector<Kernel> k = {kernel("maker", {out("x")}), kernel("viewer", {in("x", {"maker.x"}), out("y")})};
    const auto groups = [](uint32_t n) { return [n](const Case&) { return Groups{n}; }; };
    k[1].variants[0].passes = {Dispatch{"plain.comp", groups(1)}, Dispatch{"of_x.comp", groups(shown ? 1 : 0)}};
    const Graph g =
        build_graph({.kernels = k, .goals = {"viewer.y"}, .shader_ports = [](const Kernel&, const std::string& shader) {
                       return shader == "of_x.comp"    ? std::vector<std::string>{"x", "y"}
                              : shader == "plain.comp" ? std::vector<std::string>{"y"}
                                                       : std::vector<std::string>{"x"};
                     }});
    EXPECT_EQ(names(g), shown ? (std::vector<std::string>{"maker", "viewer"}) : std::vector<std::string>{"viewer"});
    EXPECT_EQ(reason(g, "maker"), shown ? "not left out" : "nothing that is asked for needs it");
  }
}

TEST(Graph, APortThatNoLivePassBindsIsNotAllocated) {
  std::vector<Kernel> k = {kernel("a", {out("x"), out("spare")})};
  const Graph g = build_graph({.kernels = k, .goals = {"a.x"}, .shader_ports = [](const Kernel&, const std::string&) {
                                 return std::vector<std::string>{"x"};
                               }});
  EXPECT_EQ(frame::resource_named(g, "a.spare"), frame::kNobody);
  const auto e = frame::explain(g, {{"scene.unused", 100}});
  const auto note = [&](const std::string& name) {
    return std::ranges::find(e.resources, name, &frame::ResourceNote::name)->note;
  };
  EXPECT_EQ(note("a.spare"), "left out: no pass that runs writes it");
  EXPECT_EQ(note("scene.unused"), "left out: no pass that runs reads it");
}

}  // namespace
}  // namespace assay::tests
