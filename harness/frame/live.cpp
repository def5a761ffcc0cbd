#include "harness/frame/live.h"

#include "harness/device/device.h"
#include "harness/device/reflect.h"

namespace assay::frame {

namespace {

using namespace device;

struct Looking {
  const Kernel& kernel;
  const Case& input;
  const ShaderPorts& shader_ports;

  void bind(LivePass& pass, const std::string& shader, uint32_t scope) const {
    for (const std::string& port : shader_ports(kernel, shader)) pass.ports.push_back({port, scope});
  }

  LivePass dispatch(const Dispatch& d) const {
    LivePass pass = {.text = "dispatch " + d.shader};
    if (d.indirect.empty()) {
      const Groups g = d.groups(input);
      if (g.x == 0 || g.y == 0 || g.z == 0) pass.reason = "no groups to run";
    }
    if (d.repeat && d.repeat(input) == 0) pass.reason = "no rows to run for";
    pass.runs = pass.reason.empty();
    bind(pass, d.shader, kCompute);
    if (!d.indirect.empty()) pass.ports.push_back({d.indirect, kIndirect});
    return pass;
  }

  LivePass clear(const Clear& c) const {
    return {.text = "clear " + c.port, .runs = true, .ports = {{c.port, kTransfer}}};
  }

  LivePass call(const DrawCall& c) const {
    LivePass pass = {.text = "draw " + c.vertex + " " + c.fragment};
    if (c.cull != Cull::none) pass.text += c.cull == Cull::back ? ", back faces culled" : ", front faces culled";
    pass.runs = c.count && c.count(input) > 0;
    if (!pass.runs) pass.reason = "nothing in view is drawn so";
    bind(pass, c.vertex, kGraphics);
    bind(pass, c.fragment, kGraphics);
    if (!c.count_port.empty()) pass.ports.push_back({c.count_port, kIndirect});
    return pass;
  }

  LivePass targets(const Draw& d) const {
    LivePass pass = {.text = "targets"};
    const auto add = [&](const std::string& port, bool clears) {
      pass.text += " " + port;
      pass.runs |= clears;
      pass.ports.push_back({port, kAttachment});
    };
    for (const ColourTarget& t : d.colours) add(t.port, t.clear.has_value());
    if (d.depth) add(d.depth->port, d.depth->clear.has_value());
    for (const DrawCall& c : d.calls) pass.runs |= c.count && c.count(input) > 0;
    if (!pass.runs) pass.reason = "neither cleared nor drawn to";
    // A draw's commands and indices are bound once, for all of its calls.
    if (!d.indices.empty()) pass.ports.push_back({d.indices, kGraphics});
    if (!d.commands.empty()) pass.ports.push_back({d.commands, kIndirect});
    return pass;
  }
};

}  // namespace

std::vector<std::string> reflected_ports(const Kernel& k, const std::string& file) {
  std::vector<std::string> ports;
  for (const Binding& b : reflect(shader(k.name, file)).bindings)
    if (b.name != "params") ports.push_back(b.name);
  return ports;
}

std::vector<LivePass> passes_of(const Kernel& k, const Variant& v, const Case& c, const ShaderPorts& shader_ports) {
  const Looking looking = {k, c, shader_ports};
  std::vector<LivePass> passes;
  for (const Pass& pass : v.passes) {
    if (const auto* dispatch = std::get_if<Dispatch>(&pass)) passes.push_back(looking.dispatch(*dispatch));
    if (const auto* clear = std::get_if<Clear>(&pass)) passes.push_back(looking.clear(*clear));
    if (const auto* draw = std::get_if<Draw>(&pass)) {
      passes.push_back(looking.targets(*draw));
      for (const DrawCall& call : draw->calls) passes.push_back(looking.call(call));
    }
  }
  return passes;
}

}  // namespace assay::frame
