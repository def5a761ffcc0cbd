// Running one variant of a planted kernel by hand, without the checker.
#pragma once
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/run.h"

namespace assay::tests {

constexpr uint32_t kPoison = 0xdeadbeef;

inline const Variant& variant_of(const Kernel& k, const std::string& name) {
  for (const Variant& v : k.variants)
    if (v.name == name) return v;
  throw std::logic_error("no variant " + name);
}

template <class T>
std::vector<T> values(const Bytes& bytes) {
  std::vector<T> v(bytes.size() / sizeof(T));
  if (!v.empty()) std::memcpy(v.data(), bytes.data(), v.size() * sizeof(T));
  return v;
}

struct Ran {
  device::Ports ports;
  device::Timing timing;
  std::vector<device::Command> commands;
};

// Outputs poisoned, a timestamp before and after.
inline Ran run_variant(device::Device& d, const Kernel& k, const std::string& variant, const Case& c,
                       std::map<std::string, uint32_t> constants = {}) {
  const Variant& v = variant_of(k, variant);
  Ran r;
  r.ports = device::make_ports(d, k, c, {}, &v);
  for (const Port& p : k.ports)
    if (p.use == Use::writes && has_port(v, p)) device::fill(d, *r.ports.at(p.name), kPoison);
  r.commands = {device::timestamp("start")};
  for (auto& command : device::lower(d, {&k, &v, std::move(constants)}, c, r.ports)) r.commands.push_back(command);
  r.commands.push_back(device::timestamp("end"));
  r.timing = device::run(d, r.commands);
  return r;
}

template <class T>
std::vector<T> read(device::Device& d, const Ran& r, const std::string& port) {
  return values<T>(device::read(d, *r.ports.at(port)));
}

}  // namespace assay::tests
