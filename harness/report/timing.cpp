#include "harness/report/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assay::report {

namespace {

constexpr double kLeastSampleNs = 200e3;
constexpr double kLeastTicks = 100;
constexpr uint32_t kMostRepeats = 4096;
constexpr uint64_t kMostSets = 160;
constexpr uint64_t kMostMemory = uint64_t{1} << 30;
// An H200's second level holds 60 MB; a round over twice that leaves nothing of the last one. A CPU's third level is
// seldom over 32 MB for the threads of one process.
constexpr uint64_t kGpuCacheSpan = uint64_t{128} << 20, kCpuCacheSpan = uint64_t{64} << 20;

bool is_work(const device::Command& c) {
  using Kind = device::Command::Kind;
  return c.kind == Kind::dispatch || c.kind == Kind::draw || c.kind == Kind::clear;
}

uint64_t memory_of(const device::Ports& ports) {
  uint64_t total = 0;
  for (const auto& [name, resource] : ports) total += device::payload_bytes(*resource);
  return total;
}

void add_set(device::Device& d, Loop& loop, const device::Plan& plan, const Case& c) {
  loop.ports.push_back(device::make_ports(d, *plan.kernel, c, {}, plan.variant));
  loop.sets.push_back(device::lower(d, plan, c, loop.ports.back()));
  loop.sets.back().push_back(device::barrier());
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

template <class Member>
double median_of(const std::vector<Sample>& all, Member member) {
  std::vector<double> values;
  values.reserve(all.size());
  for (const Sample& s : all) values.push_back(s.*member);
  return median(std::move(values));
}

// How often the rotation must be repeated to fill the shortest sample that timestamps resolve.
uint32_t calibrate(device::Device& d, Loop& loop) {
  const double least_ns = std::max(kLeastSampleNs, kLeastTicks * device::info(d).timestamp_ns);
  loop.repeats = 1;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Sample s = sample(d, loop, Cache::cold);
    const double total_ns = std::max(s.gpu_ns * s.repeats, 1.0);
    if (total_ns >= least_ns || loop.repeats == kMostRepeats) break;
    const double wanted = std::ceil(1.2 * loop.repeats * least_ns / total_ns);  // 1.2: the first executions are slower
    loop.repeats = static_cast<uint32_t>(std::min<double>(wanted, kMostRepeats));
  }
  return loop.repeats;
}

}  // namespace

Loop make_loop(device::Device& d, const device::Plan& plan, const Case& c) {
  const uint64_t span = device::info(d).type == "cpu" ? kCpuCacheSpan : kGpuCacheSpan;
  const Cost cost = cost_of(*plan.kernel, *plan.variant, c);
  const uint64_t touched = std::max<uint64_t>(cost.bytes_read + cost.bytes_written, 1);
  Loop loop;
  add_set(d, loop, plan, c);
  const uint64_t affordable = std::max<uint64_t>(kMostMemory / std::max<uint64_t>(memory_of(loop.ports[0]), 1), 1);
  const uint64_t needed = span / touched + 1;
  // Where not even the most sets leave the cache, one says as much.
  const uint64_t sets = needed > kMostSets ? 1 : std::min(needed, affordable);
  while (loop.sets.size() < sets) add_set(d, loop, plan, c);
  loop.dispatches = static_cast<uint32_t>(std::ranges::count_if(loop.sets.front(), is_work));
  loop.rotated_bytes = touched * sets;
  loop.cold_enough = loop.rotated_bytes > span;
  for (uint64_t i = 0; i < std::min<uint64_t>(sets, 3); ++i) sample(d, loop, Cache::cold);  // compiles, fills caches
  calibrate(d, loop);
  return loop;
}

void warm_up(device::Device& d, Loop& loop) {
  const double least_ns = device::warm_up_ns(device::info(d));
  if (least_ns == 0) return;
  for (double busy_ns = 0; busy_ns < least_ns;) {
    const Sample s = sample(d, loop, Cache::cold);  // its times are of one repeat
    busy_ns += s.wall_ns * s.repeats;
  }
  calibrate(d, loop);
}

Sample sample(device::Device& d, Loop& loop, Cache cache) {
  std::vector<device::Command> commands = {device::timestamp("start")};
  for (uint32_t i = 0; i < loop.repeats; ++i) {
    const auto& set = loop.sets[cache == Cache::cold ? loop.next++ % loop.sets.size() : 0];
    commands.insert(commands.end(), set.begin(), set.end());
  }
  commands.push_back(device::timestamp("end"));
  const device::Timing t = device::run(d, commands);
  const double n = loop.repeats;
  const bool stamped = device::info(d).timestamp_ns > 0 && t.stamps.size() == 2;
  const double gpu_ns = stamped ? t.stamps[1].time_ns - t.stamps[0].time_ns : t.wall_ns;
  return {.gpu_ns = gpu_ns / n, .cpu_ns = t.cpu_ns / n, .wall_ns = t.wall_ns / n, .repeats = loop.repeats};
}

std::vector<Sample> samples(device::Device& d, Loop& loop, Cache cache, uint32_t count) {
  std::vector<Sample> all;
  if (cache == Cache::hot) sample(d, loop, cache);  // brings the set into the cache
  for (uint32_t i = 0; i < count; ++i) all.push_back(sample(d, loop, cache));
  return all;
}

double median_gpu_ns(const std::vector<Sample>& all) { return median_of(all, &Sample::gpu_ns); }
double median_cpu_ns(const std::vector<Sample>& all) { return median_of(all, &Sample::cpu_ns); }

double least_gpu_ns(const std::vector<Sample>& all) {
  double least = std::numeric_limits<double>::infinity();
  for (const Sample& s : all) least = std::min(least, s.gpu_ns);
  return least;
}

}  // namespace assay::report
