// Which passes of a variant have work for a case, and what those bind.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "harness/kernel.h"

namespace assay::frame {

struct BoundPort {
  std::string port;
  uint32_t scopes = 0;  // device::Scope, where it is touched
};
struct LivePass {
  std::string text;  // "dispatch gather.comp", "draw masked.vert masked.frag"
  bool runs = false;
  std::string reason;  // why it does not run; empty if it does
  std::vector<BoundPort> ports;
};

// The ports that a kernel's shader binds. Reflected from its SPIR-V; tests without shaders bring their own.
using ShaderPorts = std::function<std::vector<std::string>(const Kernel&, const std::string& shader)>;
std::vector<std::string> reflected_ports(const Kernel&, const std::string& shader);

// In order; a draw's targets and each of its calls are told apart.
std::vector<LivePass> passes_of(const Kernel&, const Variant&, const Case&, const ShaderPorts&);

}  // namespace assay::frame
