// The chain of kernels, derived from their descriptions: who produces what each reads, which are needed, in which
// order, in which memory, with which barriers between.
#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "harness/device/device.h"
#include "harness/frame/live.h"
#include "harness/kernel.h"

namespace assay::frame {

constexpr size_t kNobody = ~size_t{0};

struct GraphInputs {
  std::span<const Kernel> kernels = {};
  FrameInputs view = {};
  std::map<std::string, uint64_t> scene = {};        // "scene.indices" -> bytes; 0: there is none of it
  std::map<std::string, std::string> variants = {};  // kernel -> variant or label; else its default
  std::vector<std::string> goals = {};
  const device::Info* device = nullptr;  // null: every variant can run
  ShaderPorts shader_ports = reflected_ports;
};

// One version of a thing: what a kernel wrote, what the scene or a case holds. Updated versions share their memory.
struct Resource {
  std::string name;            // "visibility.depth", "scene.indices", "debug_view.heat_colours"
  size_t producer = kNobody;   // node; kNobody: the scene, or the case of `owner`
  size_t owner = kNobody;      // node whose case holds it
  const Port* port = nullptr;  // that describes it; of a scene resource its first reader's
  uint64_t bytes = 0;
  size_t memory = 0;  // the resource whose memory it has; its own number, or an earlier version's
};

struct Bound {
  const Port* port = nullptr;
  size_t resource = 0;
  size_t written = kNobody;  // the version that an updating port makes of `resource`
  uint32_t scopes = 0;
};

struct Node {
  const Kernel* kernel = nullptr;
  const Variant* variant = nullptr;
  std::map<std::string, uint32_t> constants = {};
  Case input = {};
  std::vector<LivePass> passes = {};
  std::vector<Bound> ports = {};                              // those that its live passes bind
  std::vector<std::string> unbound = {};                      // those that none does
  std::optional<std::pair<uint32_t, uint32_t>> barrier = {};  // scopes from and to, before it
};

struct LeftOut {
  std::string kernel, variant, reason;
};

struct Graph {
  std::vector<Node> nodes;          // in order of execution
  std::vector<Resource> resources;  // only what the nodes bind
  std::vector<LeftOut> left_out;
  std::vector<std::string> goals;
};

// Throws std::invalid_argument for an unknown kernel, variant or goal, or a variant that the device cannot run, and
// std::runtime_error naming both kernels for a cycle and for two updaters of one version.
Graph build_graph(const GraphInputs&);

size_t resource_named(const Graph&, const std::string& name);  // kNobody where it is not in the graph
// Kernels that bind the resource without having made it.
std::vector<std::string> readers_of(const Graph&, size_t resource);

}  // namespace assay::frame
