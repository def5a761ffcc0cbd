#include "harness/frame/record.h"

#include "harness/frame/hazards.h"

namespace assay::frame {

std::vector<device::Command> record(device::Device& d, const Graph& graph, const Allocated& allocated) {
  std::vector<device::Command> commands = {device::timestamp("start")};
  for (size_t n = 0; n < graph.nodes.size(); ++n) {
    const Node& node = graph.nodes[n];
    if (node.barrier) commands.push_back(device::barrier(node.barrier->first, node.barrier->second));
    for (device::Command& c :
         device::lower(d, {node.kernel, node.variant, node.constants}, node.input, ports_of(graph, n, allocated))) {
      const bool timed = c.kind != device::Command::Kind::barrier;
      const std::string label = c.label;
      commands.push_back(std::move(c));
      if (timed) commands.push_back(device::timestamp(label));
    }
  }
  return commands;
}

std::vector<PassTime> pass_times(const device::Timing& timing) {
  std::vector<PassTime> times;
  std::string last;
  for (size_t i = 1; i < timing.stamps.size(); ++i) {
    const std::string label = without_row(timing.stamps[i].label);
    const double time_ns = timing.stamps[i].time_ns - timing.stamps[i - 1].time_ns;
    if (label == last) {
      ++times.back().commands;
      times.back().time_ns += time_ns;
      continue;
    }
    const size_t space = label.find(' ');
    times.push_back({label.substr(0, space), space == std::string::npos ? "" : label.substr(space + 1), 1, time_ns});
    last = label;
  }
  return times;
}

}  // namespace assay::frame
