#include "harness/report/yardsticks.h"

#include <algorithm>
#include <limits>

#include "harness/check/run_case.h"

namespace assay {
const std::vector<Kernel>& yardstick_kernels();  // generated
}

namespace assay::report {

namespace {

constexpr double kLeastArithmeticNs = 2e6;  // long beside an empty dispatch anywhere
constexpr uint32_t kMostGroups = 65535;

const Kernel& yardstick(const std::string& name) {
  const auto& all = yardstick_kernels();
  const auto it = std::ranges::find(all, name, &Kernel::name);
  if (it == all.end()) throw std::logic_error("no yardstick " + name);
  return *it;
}

// A yardstick that does not do its work measures nothing.
void must_compute(device::Device& d, const device::Plan& plan, const Case& c) {
  const auto ports = device::make_ports(d, *plan.kernel, c);
  device::run(d, device::lower(d, plan, c, ports));
  for (const auto& [port, expected] : plan.kernel->oracle(c))
    if (!expected.low.empty() && device::read(d, *ports.at(port)) != expected.low)
      throw std::runtime_error("the yardstick " + plan.kernel->name + " computes nonsense on " + device::info(d).name);
}

struct Best {
  double time_ns = std::numeric_limits<double>::infinity();
  std::vector<Sample> samples;
};

// The fastest of the yardstick's constants.
Best best_of(device::Device& d, const Kernel& kernel, const Case& c, uint32_t count) {
  Best best;
  for (const auto& constants : device::combinations(kernel.variants[0])) {
    const device::Plan plan{.kernel = &kernel, .variant = &kernel.variants[0], .constants = constants};
    must_compute(d, plan, c);
    Loop loop = make_loop(d, plan, c);
    auto taken = samples(d, loop, Cache::cold, count);
    const double time_ns = least_gpu_ns(taken);
    if (time_ns < best.time_ns) best = {time_ns, std::move(taken)};
  }
  return best;
}

}  // namespace

FilterFigure measure_filter(device::Device& d) {
  const Kernel& kernel = yardstick("filter_yardstick");
  const auto prepared = check::prepare(kernel, kernel.typical(kernel.extents[0]), device::info(d).traits);
  const auto ports = device::make_ports(d, kernel, prepared.input);
  const device::Plan plan{.kernel = &kernel, .variant = &kernel.variants[0]};
  const check::Outcome outcome = check::run_case(d, plan, prepared, ports, false);
  return {255 * outcome.verdicts.at(0).worst, 255 * outcome.verdicts.at(1).worst};
}

Yardsticks measure_yardsticks(device::Device& d, uint32_t count) {
  Yardsticks y;
  y.filter = measure_filter(d);
  const Kernel& empty = yardstick("empty_yardstick");
  const Case nothing_to_do = empty.typical(empty.extents[0]);
  Loop first = make_loop(d, {.kernel = &empty, .variant = &empty.variants[0]}, nothing_to_do);
  warm_up(d, first);
  const Best nothing = best_of(d, empty, nothing_to_do, count);
  y.empty_ns = nothing.time_ns;
  y.empty_samples = nothing.samples;

  const Kernel& arithmetic = yardstick("multiply_add_yardstick");
  for (uint32_t groups = 64;; groups = std::min(groups * 4, kMostGroups)) {
    const Case c = arithmetic.typical({groups, 1});
    const Best chains = best_of(d, arithmetic, c, count);
    y.operations_per_s = static_cast<double>(arithmetic.cost(c).operations) / (chains.time_ns - y.empty_ns) * 1e9;
    y.arithmetic_samples = chains.samples;
    if (chains.time_ns > kLeastArithmeticNs || groups == kMostGroups) return y;
  }
}

const CopyFigure& copy_at(device::Device& d, Yardsticks& y, uint64_t bytes, uint32_t count) {
  bytes = std::clamp<uint64_t>(bytes, 64 << 10, 128 << 20);
  const auto vectors = static_cast<uint32_t>(bytes / 32);
  const auto [it, fresh] = y.copies.try_emplace(uint64_t{vectors} * 32);
  CopyFigure& figure = it->second;
  if (!fresh) return figure;
  const Kernel& copy = yardstick("copy_yardstick");
  Best best = best_of(d, copy, copy.typical({vectors, 1}), count);
  const double moving_ns = best.time_ns - y.empty_ns;
  figure = {.bytes = it->first,
            .time_ns = best.time_ns,
            .bytes_per_s = moving_ns > 0 ? static_cast<double>(it->first) / moving_ns * 1e9
                                         : std::numeric_limits<double>::infinity(),
            .samples = std::move(best.samples)};
  return figure;
}

double limit_ns(const Yardsticks& y, const CopyFigure& copy, const Cost& cost, uint32_t dispatches) {
  const double moving = static_cast<double>(cost.bytes_read + cost.bytes_written) / copy.bytes_per_s * 1e9;
  const double computing = static_cast<double>(cost.operations) / y.operations_per_s * 1e9;
  return std::max(moving, computing) + dispatches * y.empty_ns;
}

}  // namespace assay::report
