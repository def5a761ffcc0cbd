// A graph's resources on a device, filled from the scene and the cases.
#pragma once
#include "harness/frame/graph.h"
#include "harness/scene/scene.h"

namespace assay::frame {

// Bytes of everything that the gather offers, by resource name; what port producers may name as "scene....".
std::map<std::string, uint64_t> scene_bytes(const scene::Gathered&);

struct Allocated {
  std::vector<device::Owned> resources;  // by resource; versions of one memory share it
  std::vector<device::Owned> params;     // by node
};
Allocated allocate(device::Device&, const Graph&, const scene::Gathered&);
device::Ports ports_of(const Graph&, size_t node, const Allocated&);

}  // namespace assay::frame
