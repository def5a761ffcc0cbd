// Google Benchmark over the registry: kernel/variant[constants]/WxH, GPU time as manual time, errors as counters. Its
// JSON is what compare.py reads. Usage: assay_bench [--device=X] [--benchmark_...]; ASSAY_DEVICE does as --device.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "harness/report/bench.h"

namespace {

using namespace assay;

struct Context {
  device::Handle device;
  // The oracle's answer to the input timed last: variants of a kernel at one extent come one after another.
  const Kernel* kernel = nullptr;
  Extent extent = {};
  check::Prepared prepared;
};

const check::Prepared& prepared_for(Context& context, const report::Entry& e) {
  const bool kept =
      context.kernel == e.kernel && context.extent.width == e.extent.width && context.extent.height == e.extent.height;
  if (!kept) {
    context.prepared = check::prepare(*e.kernel, report::input_of(e), device::info(*context.device).traits);
    context.kernel = e.kernel;
    context.extent = e.extent;
  }
  return context.prepared;
}

void time_entry(benchmark::State& state, Context& context, const report::Entry& e) {
  device::Device& d = *context.device;
  const check::Prepared& prepared = prepared_for(context, e);
  const report::Verified verified = report::verify(d, e, prepared);
  if (!verified.refused.empty()) return state.SkipWithError(verified.refused.c_str());
  report::Loop loop =
      report::make_loop(d, {.kernel = e.kernel, .variant = e.variant, .constants = e.constants}, prepared.input);
  report::warm_up(d, loop);
  double cpu_ns = 0, executions = 0;
  while (state.KeepRunningBatch(loop.repeats)) {
    const report::Sample s = report::sample(d, loop, report::Cache::cold);
    state.SetIterationTime(s.gpu_ns * s.repeats * 1e-9);
    cpu_ns += s.cpu_ns * s.repeats;
    executions += s.repeats;
  }
  const Cost cost = cost_of(*e.kernel, *e.variant, prepared.input);
  const auto iterations = static_cast<double>(state.iterations());
  state.SetBytesProcessed(static_cast<int64_t>(iterations * static_cast<double>(cost.bytes_read + cost.bytes_written)));
  state.SetItemsProcessed(static_cast<int64_t>(iterations * static_cast<double>(pixel_count(e.extent))));
  state.counters["device_cpu_ns"] = cpu_ns / executions;
  if (e.variant->baseline) {
    state.counters["wrong"] = static_cast<double>(verified.violations);
    state.counters["nan"] = static_cast<double>(verified.nans);
  }
  state.counters["undecided"] = static_cast<double>(verified.undecided);
  for (const auto& b : verified.bounds) {
    if (std::isfinite(b.worst)) state.counters["error " + b.name] = b.worst;
    if (std::isfinite(b.limit)) state.counters["limit " + b.name] = b.limit;
  }
}

// Takes --device=X or --device X out of the arguments.
std::string take_device(std::vector<char*>& arguments) {
  const char* from_environment = std::getenv("ASSAY_DEVICE");
  std::string device = from_environment ? from_environment : "";
  for (size_t i = 1; i < arguments.size();) {
    const std::string word = arguments[i];
    const bool joined = word.starts_with("--device="), apart = word == "--device" && i + 1 < arguments.size();
    if (!joined && !apart) {
      ++i;
      continue;
    }
    device = joined ? word.substr(9) : arguments[i + 1];
    const auto at = arguments.begin() + static_cast<std::ptrdiff_t>(i);
    arguments.erase(at, at + (joined ? 1 : 2));
  }
  return device;
}

void add_entries(Context& context) {
  report::Selection all{.all_extents = true};
  for (const Kernel& k : all_kernels()) all.kernels.push_back(&k);
  for (const report::Entry& e : report::entries_of(all))
    benchmark::RegisterBenchmark(
        fmt::format("{}/{}/{}x{}", e.kernel->name, report::label_of(e), e.extent.width, e.extent.height).c_str(),
        [&context, e](benchmark::State& state) { time_entry(state, context, e); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
}

int run(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  const std::string select = take_device(arguments);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  Context context{.device = device::open({.select = select})};
  const device::Info& i = device::info(*context.device);
  fmt::print(stderr, "device {}: {}, {} {}\n", i.index, i.name, i.driver, i.driver_info);
  benchmark::AddCustomContext("device", i.name);
  benchmark::AddCustomContext("device_uuid", i.uuid);
  benchmark::AddCustomContext("driver", i.driver + " " + i.driver_info);
  add_entries(context);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "assay_bench: {}\n", e.what());
    return 2;
  }
}
