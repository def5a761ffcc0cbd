#include "harness/frame/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "harness/frame/candidates.h"

namespace assay::frame {

namespace {

using Edges = std::vector<std::set<size_t>>;  // candidate -> those that must run before it

struct Plan {
  const GraphInputs& in;
  std::vector<Candidate> candidates = {};
  std::map<std::string, size_t> makers = {};
  std::set<size_t> needed = {};
  const std::string& name(size_t i) const { return candidates[i].node.kernel->name; }
};

std::string why_absent(const Plan& plan, const std::string& goal) {
  for (const Candidate& c : plan.candidates)
    if (goal.starts_with(c.node.kernel->name + ".") && !c.present) return "; it is left out: " + c.absent_because;
  return "";
}

void need(Plan& plan, size_t i) {
  if (!plan.needed.insert(i).second) return;
  for (const auto& [port, source] : plan.candidates[i].sources)
    if (const auto maker = plan.makers.find(source); maker != plan.makers.end()) need(plan, maker->second);
}

void need_goals(Plan& plan) {
  for (const std::string& goal : plan.in.goals) {
    const auto maker = plan.makers.find(goal);
    if (maker == plan.makers.end())
      throw std::invalid_argument(fmt::format("nothing produces {}{}", goal, why_absent(plan, goal)));
    need(plan, maker->second);
  }
}

// Who reads which version, and who updates it.
struct Users {
  std::vector<size_t> readers, updaters;
};
std::map<std::string, Users> users_of(const Plan& plan) {
  std::map<std::string, Users> users;
  for (const size_t i : plan.needed)
    for (const Bound& b : plan.candidates[i].node.ports)
      if (reads_earlier(*b.port)) {
        Users& u = users[plan.candidates[i].sources.at(b.port->name)];
        (b.port->use == Use::updates ? u.updaters : u.readers).push_back(i);
      }
  return users;
}

Edges edges_of(const Plan& plan) {
  Edges before(plan.candidates.size());
  for (const auto& [source, users] : users_of(plan)) {
    if (users.updaters.size() > 1)
      throw std::runtime_error(fmt::format("{} and {} both update {}: one of them must read what the other makes",
                                           plan.name(users.updaters[0]), plan.name(users.updaters[1]), source));
    if (!users.updaters.empty() && std::ranges::find(plan.in.goals, source) != plan.in.goals.end())
      throw std::invalid_argument(
          fmt::format("{} is overwritten by {}; ask for what that makes", source, plan.name(users.updaters[0])));
    const auto maker = plan.makers.find(source);
    for (const auto* list : {&users.readers, &users.updaters})
      for (const size_t user : *list)
        if (maker != plan.makers.end()) before[user].insert(maker->second);
    for (const size_t updater : users.updaters)
      for (const size_t reader : users.readers)
        if (reader != updater) before[updater].insert(reader);
  }
  return before;
}

[[noreturn]] void refuse_cycle(const Plan& plan, const Edges& before, const std::set<size_t>& waiting) {
  std::vector<size_t> walk = {*waiting.begin()};
  while (true) {  // backwards along what is waited for, until a kernel comes again
    const auto& earlier = before[walk.back()];
    const size_t next = *std::ranges::find_if(earlier, [&](size_t i) { return waiting.contains(i); });
    const auto again = std::ranges::find(walk, next);
    if (again != walk.end()) {
      std::string text = "a cycle of kernels: ";
      for (auto it = again; it != walk.end(); ++it) text += plan.name(*it) + " needs ";
      throw std::runtime_error(text + plan.name(next));
    }
    walk.push_back(next);
  }
}

std::vector<size_t> order_of(const Plan& plan) {
  const Edges before = edges_of(plan);
  std::set<size_t> waiting = plan.needed;
  std::vector<size_t> order;
  while (!waiting.empty()) {
    const auto ready = std::ranges::find_if(waiting, [&](size_t i) {
      return std::ranges::none_of(before[i], [&](size_t j) { return waiting.contains(j); });
    });
    if (ready == waiting.end()) refuse_cycle(plan, before, waiting);
    order.push_back(*ready);
    waiting.erase(ready);
  }
  return order;
}

uint64_t bytes_of(const Port& p, const Case& c) {
  switch (p.kind) {
    case PortKind::buffer:
      return p.count(c) * p.layout.stride;
    case PortKind::image:
      return pixel_count(p.extent ? p.extent(c) : c.extent) * bytes_per_block(format_of(p, c));
    case PortKind::textures:
      break;
  }
  uint64_t bytes = 0;
  if (const auto it = c.textures.find(p.name); it != c.textures.end())
    for (const Texture& t : it->second) bytes += t.bytes.size();
  return bytes;
}

size_t add_resource(Graph& g, Resource r) {
  const size_t at = g.resources.size();
  if (r.memory == kNobody) r.memory = at;
  g.resources.push_back(std::move(r));
  return at;
}

size_t source_resource(Graph& g, const GraphInputs& in, const Port& port, const std::string& name) {
  const size_t known = resource_named(g, name);
  if (known != kNobody) return known;
  return add_resource(g, {.name = name, .port = &port, .bytes = in.scene.at(name), .memory = kNobody});
}

void bind_resources(Graph& g, const GraphInputs& in, size_t at, const Candidate& c) {
  Node& node = g.nodes[at];
  for (Bound& b : node.ports) {
    Resource own = {.name = resource_name(node, *b.port),
                    .port = b.port,
                    .bytes = bytes_of(*b.port, node.input),
                    .memory = kNobody};
    if (reads_earlier(*b.port)) {
      b.resource = source_resource(g, in, *b.port, c.sources.at(b.port->name));
      if (b.port->use != Use::updates) continue;
      own.producer = at;
      own.memory = g.resources[b.resource].memory;
      b.written = add_resource(g, std::move(own));
      continue;
    }
    (b.port->use == Use::writes ? own.producer : own.owner) = at;
    b.resource = add_resource(g, std::move(own));
  }
}

// What a node must wait for, as scopes from and to, unless a barrier since then covers it.
void place_barriers(Graph& g) {
  struct Touch {
    size_t node;
    uint32_t scopes;
    bool writes;
  };
  std::map<size_t, std::vector<Touch>> touches;  // by memory
  const auto covered = [&](const Touch& t, size_t now, uint32_t to) {
    for (size_t i = t.node + 1; i <= now; ++i)
      if (const auto& b = g.nodes[i].barrier; b && (t.scopes & ~b->first) == 0 && (to & ~b->second) == 0) return true;
    return false;
  };
  for (size_t n = 0; n < g.nodes.size(); ++n) {
    uint32_t from = 0, to = 0;
    for (const Bound& b : g.nodes[n].ports)
      for (const Touch& t : touches[g.resources[b.resource].memory])
        if ((t.writes || b.port->use != Use::reads) && t.node != n && !covered(t, n, b.scopes))
          from |= t.scopes, to |= b.scopes;
    if (from) g.nodes[n].barrier = {from, to};
    for (const Bound& b : g.nodes[n].ports)
      touches[g.resources[b.resource].memory].push_back({n, b.scopes, b.port->use != Use::reads});
  }
}

}  // namespace

size_t resource_named(const Graph& g, const std::string& name) {
  const auto it = std::ranges::find(g.resources, name, &Resource::name);
  return it == g.resources.end() ? kNobody : static_cast<size_t>(it - g.resources.begin());
}

std::vector<std::string> readers_of(const Graph& g, size_t resource) {
  std::vector<std::string> readers;
  for (const Node& node : g.nodes)
    if (std::ranges::any_of(node.ports,
                            [&](const Bound& b) { return b.resource == resource && b.port->use != Use::writes; }))
      readers.push_back(node.kernel->name);
  return readers;
}

Graph build_graph(const GraphInputs& in) {
  Graph g = {.goals = in.goals};
  Plan plan = {.in = in};
  plan.candidates = candidates_of(in, g.left_out);
  plan.makers = makers_of(plan.candidates);
  need_goals(plan);
  for (size_t i = 0; i < plan.candidates.size(); ++i) {
    const Candidate& c = plan.candidates[i];
    if (!plan.needed.contains(i))
      g.left_out.push_back(
          {plan.name(i), c.node.variant->name, c.present ? "nothing that is asked for needs it" : c.absent_because});
  }
  for (const size_t i : order_of(plan)) {
    g.nodes.push_back(plan.candidates[i].node);
    bind_resources(g, in, g.nodes.size() - 1, plan.candidates[i]);
  }
  place_barriers(g);
  return g;
}

}  // namespace assay::frame
