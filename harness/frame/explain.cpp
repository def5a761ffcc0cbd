#include "harness/frame/explain.h"

#include <fmt/format.h>

#include <algorithm>

namespace assay::frame {

namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

// What a node's results are for: "visibility is read by debug_view; depth is asked for".
std::string purpose_of(const Graph& g, size_t node) {
  std::vector<std::string> uses;
  for (const Bound& b : g.nodes[node].ports) {
    if (b.port->use == Use::reads) continue;
    const size_t made = b.written != kNobody ? b.written : b.resource;
    auto readers = readers_of(g, made);
    std::erase(readers, g.nodes[node].kernel->name);
    if (!readers.empty()) uses.push_back(b.port->name + " is read by " + joined(readers));
    if (std::ranges::find(g.goals, g.resources[made].name) != g.goals.end())
      uses.push_back(b.port->name + " is asked for");
  }
  return fmt::format("{}", fmt::join(uses, "; "));
}

void explain_node(const Graph& g, size_t at, Explanation& e) {
  const Node& node = g.nodes[at];
  const std::string variant = device::label_of(*node.variant, node.constants), purpose = purpose_of(g, at);
  for (const LivePass& pass : node.passes)
    e.passes.push_back({node.kernel->name, variant, pass.text, pass.runs, pass.runs ? purpose : pass.reason});
}

ResourceNote note_of(const Graph& g, size_t at) {
  const Resource& r = g.resources[at];
  ResourceNote note = {.name = r.name, .readers = readers_of(g, at)};
  note.producer = r.producer != kNobody ? g.nodes[r.producer].kernel->name : r.owner != kNobody ? "case" : "scene";
  std::erase(note.readers, note.producer);
  if (r.memory == at && r.bytes == 0)
    note.note = "there is none of it";
  else if (r.memory == at)
    note.bytes = r.bytes;
  else
    note.note = "shares the memory of " + g.resources[r.memory].name;
  return note;
}

void explain_unbound(const Graph& g, Explanation& e) {
  for (const Node& node : g.nodes)
    for (const std::string& port : node.unbound) {
      const Port& p = port_of(*node.kernel, port);
      if (p.use == Use::writes)
        e.resources.push_back({.name = node.kernel->name + "." + port,
                               .producer = node.kernel->name,
                               .note = "left out: no pass that runs writes it"});
    }
}

std::string megabytes(uint64_t bytes) {
  return bytes < 10'000 ? fmt::format("{} B", bytes) : fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3);
}

}  // namespace

Explanation explain(const Graph& g, const std::map<std::string, uint64_t>& scene_bytes) {
  Explanation e;
  for (size_t i = 0; i < g.nodes.size(); ++i) explain_node(g, i, e);
  for (const LeftOut& l : g.left_out) e.passes.push_back({l.kernel, l.variant, "all passes", false, l.reason});
  for (size_t i = 0; i < g.resources.size(); ++i) e.resources.push_back(note_of(g, i));
  for (size_t i = 0; i < g.nodes.size(); ++i)
    if (const auto stride = g.nodes[i].kernel->params.stride)
      e.resources.push_back({g.nodes[i].kernel->name + ".params", stride, "case", {g.nodes[i].kernel->name}, ""});
  explain_unbound(g, e);
  for (const auto& [name, bytes] : scene_bytes)
    if (resource_named(g, name) == kNobody)
      e.resources.push_back({.name = name, .producer = "scene", .note = "left out: no pass that runs reads it"});
  return e;
}

uint64_t total_bytes(const Explanation& e) {
  uint64_t bytes = 0;
  for (const ResourceNote& r : e.resources) bytes += r.bytes;
  return bytes;
}

std::string to_text(const Explanation& e) {
  size_t name = 0, pass = 0;
  for (const PassNote& p : e.passes) {
    name = std::max(name, p.kernel.size() + p.variant.size() + 1);
    pass = std::max(pass, p.pass.size());
  }
  std::string text = "Passes\n";
  for (const PassNote& p : e.passes)
    text += fmt::format("  {:<8} {:<{}}  {:<{}}  {}\n", p.runs ? "runs" : "left out", p.kernel + "." + p.variant, name,
                        p.pass, pass, p.reason);
  name = 0;
  for (const ResourceNote& r : e.resources) name = std::max(name, r.name.size());
  text += fmt::format("Resources, {} in all\n", megabytes(total_bytes(e)));
  for (const ResourceNote& r : e.resources) {
    text += fmt::format("  {:>12}  {:<{}}  from {}", megabytes(r.bytes), r.name, name, r.producer);
    if (!r.readers.empty()) text += ", read by " + joined(r.readers);
    text += r.note.empty() ? "\n" : "; " + r.note + "\n";
  }
  return text;
}

nlohmann::json to_json(const Explanation& e) {
  nlohmann::json passes = nlohmann::json::array(), resources = nlohmann::json::array();
  for (const PassNote& p : e.passes)
    passes.push_back(
        {{"kernel", p.kernel}, {"variant", p.variant}, {"pass", p.pass}, {"runs", p.runs}, {"reason", p.reason}});
  for (const ResourceNote& r : e.resources)
    resources.push_back(
        {{"name", r.name}, {"bytes", r.bytes}, {"producer", r.producer}, {"readers", r.readers}, {"note", r.note}});
  return {{"passes", passes}, {"resources", resources}, {"bytes", total_bytes(e)}};
}

}  // namespace assay::frame
