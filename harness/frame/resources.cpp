#include "harness/frame/resources.h"

#include <optional>
#include <span>
#include <stdexcept>

namespace assay::frame {

namespace {

std::map<std::string, std::span<const std::byte>> scene_buffers(const scene::Gathered& g) {
  return {{"scene.positions", std::as_bytes(std::span(g.positions))},
          {"scene.attributes", std::as_bytes(std::span(g.attributes))},
          {"scene.indices", std::as_bytes(std::span(g.indices))},
          {"scene.surfaces", std::as_bytes(std::span(g.surfaces))},
          {"scene.draws", std::as_bytes(std::span(g.draws))},
          {"scene.materials", std::as_bytes(std::span(g.materials))},
          {"scene.surface_slots", std::as_bytes(std::span(g.surface_slots))},
          {"scene.lights", std::as_bytes(std::span(g.lights))},
          {"scene.decals", std::as_bytes(std::span(g.decals))},
          {"scene.receivers", std::as_bytes(std::span(g.receivers))},
          {"scene.cluster_items", std::as_bytes(std::span(g.cluster_items))},
          {"scene.cluster_edges", std::as_bytes(std::span(g.cluster_edges))},
          {"scene.slice_edges", std::as_bytes(std::span(g.slice_edges))},
          {"scene.shadow_views", std::as_bytes(std::span(g.shadow_views))},
          {"scene.shadow_casters", std::as_bytes(std::span(g.shadow_casters))},
          {"scene.shadow_draws", std::as_bytes(std::span(g.shadow_draws))},
          {"scene.shadow_still_tiles", std::as_bytes(std::span(g.shadow_still_tiles))},
          {"scene.shadow_tiles", std::as_bytes(std::span(g.shadow_tiles))},
          {"scene.particles", std::as_bytes(std::span(g.particles))},
          {"scene.particle_order", std::as_bytes(std::span(g.particle_order))}};
}

std::map<std::string, std::span<const Texture>> scene_textures(const scene::Gathered& g) {
  return {{"scene.textures", g.textures}, {"scene.decal_atlas", g.decal_atlas}};
}

struct Contents {
  std::span<const std::byte> bytes = {};
  std::span<const Texture> textures = {};
  bool given = false;
};

Contents contents_of(const Graph& graph, const Resource& r, const scene::Gathered& gathered) {
  if (r.producer != kNobody) return {};
  if (r.owner == kNobody) {
    if (r.port->kind == PortKind::textures) return {.textures = scene_textures(gathered).at(r.name), .given = true};
    return {.bytes = scene_buffers(gathered).at(r.name), .given = true};
  }
  const Case& input = graph.nodes[r.owner].input;
  if (r.port->kind == PortKind::textures) return {.textures = input.textures.at(r.port->name), .given = true};
  return {.bytes = input.inputs.at(r.port->name), .given = true};
}

// The second format that a port sees an image in, its maker's or an updater's.
std::optional<Format> view_of(const Graph& graph, const Resource& r) {
  for (const Node& node : graph.nodes)
    for (const Bound& b : node.ports)
      if (b.port->view && graph.resources[b.resource].memory == r.memory) return b.port->view;
  return {};
}

device::Owned make(device::Device& d, const Graph& graph, const Resource& r, const Contents& contents) {
  const Node* maker = r.producer != kNobody ? &graph.nodes[r.producer]
                      : r.owner != kNobody  ? &graph.nodes[r.owner]
                                            : nullptr;
  switch (r.port->kind) {
    case PortKind::buffer:
      return device::make_buffer(d, r.name, contents.given ? contents.bytes.size() : r.bytes);
    case PortKind::image: {
      if (!maker) throw std::logic_error(r.name + ": the scene holds no images");
      const Extent extent = r.port->extent ? r.port->extent(maker->input) : maker->input.extent;
      return device::make_image(d, r.name, format_of(*r.port, maker->input), view_of(graph, r), extent);
    }
    case PortKind::textures: {
      const uint64_t slots = r.port->count(maker ? maker->input : Case());
      return device::make_textures(d, r.name, contents.textures, slots);
    }
  }
  throw std::logic_error("a port of no kind");
}

}  // namespace

std::map<std::string, uint64_t> scene_bytes(const scene::Gathered& g) {
  std::map<std::string, uint64_t> bytes;
  for (const auto& [name, data] : scene_buffers(g)) bytes[name] = data.size();
  for (const auto& [name, textures] : scene_textures(g)) {
    bytes[name] = 0;
    for (const Texture& t : textures) bytes[name] += t.bytes.size();
  }
  return bytes;
}

Allocated allocate(device::Device& d, const Graph& graph, const scene::Gathered& gathered) {
  Allocated a;
  for (size_t i = 0; i < graph.resources.size(); ++i) {
    const Resource& r = graph.resources[i];
    if (r.memory != i) {
      a.resources.push_back(a.resources[r.memory]);
      continue;
    }
    const Contents contents = contents_of(graph, r, gathered);
    device::Owned made = make(d, graph, r, contents);
    if (!contents.bytes.empty()) device::write(d, *made, contents.bytes);
    a.resources.push_back(std::move(made));
  }
  for (const Node& node : graph.nodes) {
    const Bytes& bytes = node.input.parameters;
    if (bytes.size() != node.kernel->params.stride)
      throw std::logic_error(node.kernel->name + ": the frame's case has parameters of another size");
    device::Owned params =
        bytes.empty() ? nullptr : device::make_buffer(d, node.kernel->name + ".params", bytes.size());
    if (params) device::write(d, *params, bytes);
    a.params.push_back(std::move(params));
  }
  return a;
}

device::Ports ports_of(const Graph& graph, size_t node, const Allocated& a) {
  device::Ports ports;
  for (const Bound& b : graph.nodes[node].ports) ports[b.port->name] = a.resources[b.resource];
  if (a.params[node]) ports["params"] = a.params[node];
  return ports;
}

}  // namespace assay::frame
