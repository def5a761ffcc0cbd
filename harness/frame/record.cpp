#include "harness/frame/record.h"

#include "harness/frame/hazards.h"

namespace assay::frame {

namespace {

// Rows of a repeated pass, and calls of a draw, have one timestamp: between them it would make each wait for the other.
bool continues(const std::vector<device::Command>& commands, size_t i) {
  return i + 1 < commands.size() && commands[i + 1].kind != device::Command::Kind::barrier &&
         without_row(commands[i].label) == without_row(commands[i + 1].label);
}

}  // namespace

std::vector<device::Command> record(device::Device& d, const Graph& graph, const Allocated& allocated) {
  std::vector<device::Command> commands = {device::timestamp("start")};
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    const Node& node = graph.nodes[n];
    if (node.barrier) commands.push_back(device::barrier(node.barrier->first, node.barrier->second));
    const auto own =
        device::lower(d, {node.kernel, node.variant, node.constants}, node.input, ports_of(graph, n, allocated));
    for (size_t i = 0; i < own.size(); ++i) {
      commands.push_back(own[i]);
      if (own[i].kind != device::Command::Kind::barrier && !continues(own, i))
        commands.push_back(device::timestamp(without_row(own[i].label)));
    }
  }
  return commands;
}

std::vector<PassTime> pass_times(std::span<const device::Command> commands, const device::Timing& timing) {
  std::vector<PassTime> times;
  uint32_t count = 0;
  for (const device::Command& c : commands) {
    if (c.kind != device::Command::Kind::timestamp) {
      count += c.kind != device::Command::Kind::barrier;
      continue;
    }
    const size_t i = times.size() + 1;
    if (count == 0 || i >= timing.stamps.size()) continue;  // the start; a queue without timestamps
    const size_t space = c.label.find(' ');
    times.push_back({c.label.substr(0, space), space == std::string::npos ? "" : c.label.substr(space + 1), count,
                     timing.stamps[i].time_ns - timing.stamps[i - 1].time_ns});
    count = 0;
  }
  return times;
}

}  // namespace assay::frame
