// A kernel's ports as resources, filled from a case.
#include <fmt/format.h>

#include "harness/device/internal.h"

namespace assay::device {

namespace {

[[noreturn]] void refuse(const Kernel& k, const Case& c, const std::string& port, const std::string& what) {
  throw std::logic_error(fmt::format("{}: case '{}': port {}: {}", k.name, c.name, port, what));
}

const Port* find_port(const Kernel& k, const std::string& name) {
  for (const Port& p : k.ports)
    if (p.name == name) return &p;
  return nullptr;
}

// A misspelt input would otherwise be left out in silence.
void refuse_strangers(const Kernel& k, const Case& c) {
  for (const auto& [name, bytes] : c.inputs) {
    const Port* p = find_port(k, name);
    if (!p || p->kind == PortKind::textures)
      refuse(k, c, name, "the case has an input for it, the kernel no such buffer or image");
    if (p->use == assay::Use::writes) refuse(k, c, name, "the case has an input for it, but it is only written");
  }
  for (const auto& [name, textures] : c.textures) {
    const Port* p = find_port(k, name);
    if (!p || p->kind != PortKind::textures)
      refuse(k, c, name, "the case has textures for it, the kernel no such port");
  }
}

Owned make_port(Device& d, const Kernel& k, const Case& c, const Port& p) {
  const std::string name = k.name + "." + p.name;
  switch (p.kind) {
    case PortKind::buffer:
      if (!p.count || p.layout.stride == 0) refuse(k, c, p.name, "a buffer needs a count and a layout");
      return make_buffer(d, name, p.count(c) * p.layout.stride);
    case PortKind::image:
      return make_image(d, name, format_of(p, c), p.view, p.extent ? p.extent(c) : c.extent);
    case PortKind::textures: {
      const auto it = c.textures.find(p.name);
      const std::span<const Texture> given = it == c.textures.end() ? std::span<const Texture>() : it->second;
      return make_textures(d, name, given, p.count ? p.count(c) : 16);
    }
  }
  throw std::logic_error("a port of no kind");
}

void write_input(Device& d, const Kernel& k, const Case& c, const Port& p, Resource& r) {
  if (p.use == assay::Use::writes || p.kind == PortKind::textures) return;
  const auto it = c.inputs.find(p.name);
  if (it == c.inputs.end()) refuse(k, c, p.name, "it is read, and the case has no input for it");
  if (it->second.size() != payload_bytes(r))
    refuse(k, c, p.name, fmt::format("{} bytes given for {}", it->second.size(), payload_bytes(r)));
  write(d, r, it->second);
}

}  // namespace

Ports make_ports(Device& d, const Kernel& k, const Case& c, Ports have, const Variant* variant) {
  refuse_strangers(k, c);
  for (const Port& p : k.ports) {
    if (have.contains(p.name) || (variant && !has_port(*variant, p))) continue;
    Owned r = make_port(d, k, c, p);
    write_input(d, k, c, p, *r);
    have[p.name] = std::move(r);
  }
  if (have.contains("params")) return have;
  if (c.parameters.size() != k.params.stride)
    refuse(k, c, "params", fmt::format("{} bytes given for {}", c.parameters.size(), k.params.stride));
  if (k.params.stride == 0) return have;
  have["params"] = make_buffer(d, k.name + ".params", k.params.stride);
  write(d, *have["params"], c.parameters);
  return have;
}

}  // namespace assay::device
