#include "harness/check/run_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/oracle.h"

namespace assay::check {

Prepared prepare(const Kernel& kernel, Case input, const DeviceTraits& traits) {
  input.device = traits;
  Answer answer = kernel.oracle(input);
  return {std::move(input), std::move(answer)};
}

std::vector<Bound> bounds_for(const Kernel& kernel, const Variant& variant) {
  std::vector<Bound> bounds;
  for (const Bound& bound : bounds_of(kernel, variant))
    if (std::ranges::all_of(bound.ports, [&](const auto& p) { return has_port(variant, port_of(kernel, p)); }))
      bounds.push_back(bound);
  return bounds;
}

uint32_t poison_word(uint64_t seed, uint32_t choice) {
  Pcg32 rng(seed, 0x706f69736f6eull);
  const uint32_t sign = rng.next() & 0x80000000u;
  const uint32_t mantissa = (rng.next() & 0x003fffffu) | 1u;
  const uint32_t word = sign | 0x7fc00000u | mantissa;
  // Flipping the sign and the mantissa's low 22 bits changes each byte and keeps a NaN; all ones would be a plausible
  // word.
  const uint32_t other = word ^ 0x803fffffu;
  const auto usable = [](uint32_t w) { return w == 0xffffffffu ? w ^ 0x00010101u : w; };
  return usable(choice == 0 ? word : other);
}

uint32_t poison_of(const Port& port, uint64_t seed, uint32_t choice) {
  const uint32_t word = poison_word(seed, choice);
  return port.kind == PortKind::image && port.format == Format::d32_float ? 0x3f000000u | (word & 0x007fffffu) : word;
}

const Fault& fault_of(const Outcome& o, const Variant& v) {
  return !o.memory.text.empty() || v.baseline ? o.memory : o.wrong;
}

namespace {

bool is_poisoned(const Port& port) { return port.use == Use::writes && port.kind != PortKind::textures; }

// One run's surroundings, so that it can be repeated with another poison.
struct Run {
  device::Device& device;
  const device::Plan& plan;
  const Prepared& prepared;
  const device::Ports& ports;
  std::vector<device::Command> commands;
  std::vector<Bound> bounds;
};

device::Resource& resource_of(const Run& run, const std::string& port) { return *run.ports.at(port); }

// What is not written shows, targets that a draw should have cleared as well as buffers. Of updated ports the guard.
void poison_and_run(const Run& run, uint32_t choice) {
  for (const Port& port : run.plan.kernel->ports) {
    if (!has_port(*run.plan.variant, port)) continue;
    const bool updated = port.use == Use::updates && port.kind != PortKind::textures;
    if (updated || is_poisoned(port))
      device::fill(run.device, resource_of(run, port.name), poison_of(port, run.prepared.input.seed, choice));
    if (updated) device::write(run.device, resource_of(run, port.name), run.prepared.input.inputs.at(port.name));
  }
  device::run(run.device, run.commands);
}

// Behind every port that was filled, and in every input.
Fault memory_fault(const Run& run, bool inputs) {
  for (const Port& port : run.plan.kernel->ports) {
    if (port.kind == PortKind::textures || !has_port(*run.plan.variant, port)) continue;
    const device::Resource& resource = resource_of(run, port.name);
    if (port.use == Use::reads) {
      if (!inputs) continue;
      const auto given = run.prepared.input.inputs.find(port.name);
      if (given != run.prepared.input.inputs.end() && device::read(run.device, resource) != given->second)
        return {"input written", fmt::format("input {} was written", port.name)};
      continue;
    }
    const uint32_t poison = poison_of(port, run.prepared.input.seed, 0);
    const Bytes guard = device::read_guard(run.device, resource);
    for (size_t i = 0; i + 4 <= guard.size(); i += 4) {
      uint32_t word;
      std::memcpy(&word, guard.data() + i, 4);
      if (word != poison)
        return {"stray write " + port.name,
                fmt::format("stray write behind {}: byte {} of the guard holds 0x{:08x}", port.name, i, word)};
    }
  }
  return {};
}

using ReadBack = std::map<std::string, Bytes>;

ReadBack read_judged(const Run& run) {
  ReadBack got;
  for (const Bound& bound : run.bounds)
    for (const std::string& port : bound.ports)
      if (!got.contains(port)) got[port] = device::read(run.device, resource_of(run, port));
  return got;
}

const Expected& expected_of(const Run& run, const Bound& bound) {
  const auto it = run.prepared.answer.find(bound.answer.empty() ? bound.ports.at(0) : bound.answer);
  if (it == run.prepared.answer.end())
    throw std::logic_error(fmt::format("{}: the oracle says nothing of {}", run.plan.kernel->name, name_of(bound)));
  return it->second;
}

// Elements of an updated port outside the live runs keep what they held.
Fault update_fault(const Port& port, const Expected& expected, const Bytes& before, const Bytes& got) {
  const uint32_t stride = layout_of_port(port).stride;
  auto runs = live_runs(expected, got.size() / stride);
  runs.push_back({got.size() / stride, 0});
  uint64_t from = 0;
  for (const Expected::Run& live : runs) {
    for (uint64_t i = from; i < live.first; ++i)
      if (std::memcmp(before.data() + i * stride, got.data() + i * stride, stride) != 0)
        return {"touched " + port.name, fmt::format("{}: element {} was written", port.name, i)};
    from = live.first + live.count;
  }
  return {};
}

// Suspects still hold poison; only a second run under another poison convicts them.
Fault misuse_fault(const Run& run, const Port& port, const Expected& expected, const Bytes& got) {
  if (port.use == Use::updates) return update_fault(port, expected, run.prepared.input.inputs.at(port.name), got);
  if (!is_poisoned(port)) return {};
  const Layout layout = layout_of_port(port);
  const uint32_t poison = poison_of(port, run.prepared.input.seed, 0);
  if (const auto i = strayed(layout, expected, got, poison))
    return {"touched " + port.name, fmt::format("{}: element {} was written", port.name, *i)};
  const auto suspects = untouched(layout, expected, got, poison);
  if (suspects.empty()) return {};
  const uint32_t second = poison_of(port, run.prepared.input.seed, 1);
  poison_and_run(run, 1);
  const auto again = untouched(layout, expected, device::read(run.device, resource_of(run, port.name)), second);
  for (const uint64_t i : suspects)
    if (std::ranges::binary_search(again, i))
      return {"unwritten " + port.name, fmt::format("{}: element {} was not written", port.name, i)};
  return {};
}

std::string place_in_image(const Case& c, const Layout& layout, const Bytes& got, uint64_t element) {
  if (c.extent.width == 0 || got.size() / layout.stride != pixels(c)) return "";
  return fmt::format(" at pixel ({}, {})", element % c.extent.width, element / c.extent.width);
}

void judge_bound(const Run& run, const Bound& bound, ReadBack& got, Outcome& outcome) {
  const Expected& expected = expected_of(run, bound);
  std::vector<Layout> layouts;
  std::vector<Bytes> bytes;  // lent by `got`, which may be megabytes
  for (const std::string& name : bound.ports) {
    const Port& port = port_of(*run.plan.kernel, name);
    layouts.push_back(layout_of_port(port));
    bytes.push_back(std::move(got.at(name)));
    Fault misuse = misuse_fault(run, port, expected, bytes.back());
    Fault& of = expected.live ? outcome.wrong : outcome.memory;
    if (of.text.empty()) of = std::move(misuse);
  }
  outcome.verdicts.push_back(judge(bound, layouts, expected, bytes));
  const Verdict& v = outcome.verdicts.back();
  if (v.violations != 0 && outcome.wrong.text.empty())
    outcome.wrong = {name_of(bound),
                     fmt::format("{}: {}{}; {} of {} elements wrong; bound: limit {:g}, {}", name_of(bound), v.first,
                                 place_in_image(run.prepared.input, layouts[0], bytes[0], v.element), v.violations,
                                 v.judged, bound.limit, bound.reason)};
  for (size_t i = 0; i < bytes.size(); ++i) got.at(bound.ports[i]) = std::move(bytes[i]);
}

}  // namespace

Outcome run_case(device::Device& device, const device::Plan& plan, const Prepared& prepared, const device::Ports& ports,
                 bool inputs) {
  const Run run{device,
                plan,
                prepared,
                ports,
                device::lower(device, plan, prepared.input, ports),
                bounds_for(*plan.kernel, *plan.variant)};
  poison_and_run(run, 0);
  Outcome outcome{.memory = memory_fault(run, inputs)};
  ReadBack got = read_judged(run);
  for (const Bound& bound : run.bounds) judge_bound(run, bound, got, outcome);
  return outcome;
}

namespace {

Outcome failed(const std::string& kind, const std::string& text) { return {.memory = {kind, text}}; }

Outcome run_once(Session& session, const device::Plan& plan, const Prepared& prepared, device::Ports& ports,
                 bool inputs) {
  try {
    ports = device::make_ports(*session.device, *plan.kernel, prepared.input, std::move(ports), plan.variant);
    return run_case(*session.device, plan, prepared, ports, inputs);
  } catch (const device::Lost&) {
    throw;
  } catch (const device::OutOfMemory& e) {
    return failed("out of memory", e.what());
  } catch (const device::Error& e) {
    return failed("device error", e.what());
  }
}

void replace_device(Session& session, device::Ports& ports) {
  ports.clear();  // they belong to the device
  session.device.reset();
  session.device = device::open(session.options);
}

}  // namespace

Outcome attempt(Session& session, const device::Plan& plan, const Prepared& prepared, device::Ports& ports,
                bool inputs) {
  try {
    return run_once(session, plan, prepared, ports, inputs);
  } catch (const device::Lost&) {
    replace_device(session, ports);
  }
  try {
    Outcome again = run_once(session, plan, prepared, ports, inputs);
    again.flaky = true;
    return again;
  } catch (const device::Lost& e) {
    replace_device(session, ports);
    return failed("device lost", fmt::format("device lost, and again on a fresh one: {}", e.what()));
  }
}

}  // namespace assay::check
