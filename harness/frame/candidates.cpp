#include "harness/frame/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace assay::frame {

namespace {

void choose_variant(Node& node, const std::string& choice) {
  for (const Variant& v : node.kernel->variants)
    for (const auto& constants : device::combinations(v))
      if (device::label_of(v, constants) == choice || (v.name == choice && !node.variant)) {
        node.variant = &v;
        node.constants = constants;
        if (device::label_of(v, constants) == choice) return;
      }
  if (node.variant) return;
  std::string names;
  for (const Variant& v : node.kernel->variants) names += (names.empty() ? "" : ", ") + v.name;
  throw std::invalid_argument(fmt::format("{} has no variant '{}'; there are {}", node.kernel->name, choice, names));
}

void bind_ports(Node& node) {
  std::map<std::string, uint32_t> scopes;
  for (const LivePass& pass : node.passes)
    if (pass.runs)
      for (const BoundPort& b : pass.ports) scopes[b.port] |= b.scopes;
  for (const Port& p : node.kernel->ports) {
    if (!has_port(*node.variant, p)) continue;
    if (scopes.contains(p.name))
      node.ports.push_back({.port = &p, .scopes = scopes.at(p.name)});
    else
      node.unbound.push_back(p.name);
  }
}

Candidate candidate_of(const Kernel& k, const GraphInputs& in) {
  Candidate c;
  c.node.kernel = &k;
  const auto choice = in.variants.find(k.name);
  choose_variant(c.node, choice == in.variants.end() ? k.default_variant : choice->second);
  if (in.device)
    if (const std::string missing = device::missing(*in.device, *c.node.variant); !missing.empty())
      throw std::invalid_argument(
          fmt::format("{}.{} cannot run on {}: {}", k.name, c.node.variant->name, in.device->name, missing));
  c.node.input = k.frame(in.view);
  c.node.passes = passes_of(k, *c.node.variant, c.node.input, in.shader_ports);
  bind_ports(c.node);
  if (std::ranges::none_of(c.node.passes, &LivePass::runs))
    c.present = false, c.absent_because = "this frame has no work for it";
  return c;
}

void require_input(const Candidate& c, const Port& p) {
  const Case& input = c.node.input;
  if (p.kind == PortKind::textures ? input.textures.contains(p.name) : input.inputs.contains(p.name)) return;
  throw std::logic_error(fmt::format("{}: port {} names no producer, and the frame's case has no input for it",
                                     c.node.kernel->name, p.name));
}

// The first producer that is there; empty: none.
std::string source_of(const Port& p, const GraphInputs& in, const std::map<std::string, size_t>& makers,
                      const std::string& own) {
  for (const std::string& producer : p.producers)
    if (producer != own && (makers.contains(producer) || in.scene.contains(producer))) return producer;
  return {};
}

// Whether every port that it reads has a source; notes the sources or, where one is missing, the reason.
bool find_sources(Candidate& c, const GraphInputs& in, const std::map<std::string, size_t>& makers) {
  for (const Bound& b : c.node.ports) {
    if (!reads_earlier(*b.port)) {
      if (b.port->use != Use::writes) require_input(c, *b.port);
      continue;
    }
    const std::string source = source_of(*b.port, in, makers, resource_name(c.node, *b.port));
    if (source.empty()) {
      c.absent_because = fmt::format("nothing produces {} for its port {}", b.port->producers[0], b.port->name);
      return false;
    }
    c.sources[b.port->name] = source;
  }
  return true;
}

}  // namespace

std::string resource_name(const Node& node, const Port& p) { return node.kernel->name + "." + p.name; }

bool reads_earlier(const Port& p) { return p.use != Use::writes && !p.producers.empty(); }

std::map<std::string, size_t> makers_of(const std::vector<Candidate>& candidates) {
  std::map<std::string, size_t> makers;
  for (size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].present)
      for (const Bound& b : candidates[i].node.ports)
        if (b.port->use != Use::reads) makers[resource_name(candidates[i].node, *b.port)] = i;
  return makers;
}

std::vector<Candidate> candidates_of(const GraphInputs& in, std::vector<LeftOut>& left_out) {
  for (const auto& [name, choice] : in.variants)
    if (std::ranges::find(in.kernels, name, &Kernel::name) == in.kernels.end())
      throw std::invalid_argument("no kernel '" + name + "'");
  std::vector<Candidate> candidates;
  for (const Kernel& k : in.kernels) {
    if (k.frame)
      candidates.push_back(candidate_of(k, in));
    else
      left_out.push_back({k.name, k.default_variant, "it is not part of a frame"});
  }
  // What loses its last source goes, and may take others with it.
  for (bool changed = true; changed;) {
    changed = false;
    const auto makers = makers_of(candidates);
    for (Candidate& c : candidates)
      if (c.present && !find_sources(c, in, makers)) c.present = false, changed = true;
  }
  return candidates;
}

}  // namespace assay::frame
