// The one timing loop: whatever times a kernel, the bench command or Google Benchmark, samples here.
#pragma once
#include <cstdint>
#include <vector>

#include "harness/device/device.h"

namespace assay::report {

// A sample is one submission of `repeats` executions; the figures are of one execution, barrier behind it included.
struct Sample {
  double gpu_ns = 0;  // by timestamps; wall time where the device has none
  double cpu_ns = 0;  // of the whole process
  double wall_ns = 0;
  uint32_t repeats = 1;
};

enum class Cache { cold, hot };

// Executions of one plan over several equal sets of resources. Going round the sets keeps the inputs out of the cache.
struct Loop {
  std::vector<device::Ports> ports;                // of every set; commands do not own what they bind
  std::vector<std::vector<device::Command>> sets;  // an execution each, with the barrier that orders it before the next
  uint32_t dispatches = 0;                         // dependent dispatches, draws and clears an execution
  uint64_t rotated_bytes = 0;                      // what one round over all sets touches
  bool cold_enough = false;                        // rotated_bytes exceed any cache expected on this device
  uint32_t repeats = 1;                            // executions a sample
  size_t next = 0;                                 // where the rotation stands
};

// Makes the resources, and finds how many executions last 200 us or 100 ticks, whichever is longer.
// Only enough sets to exceed the cache, 160 at most, and within 1 GiB.
Loop make_loop(device::Device&, const device::Plan&, const Case&);
// Keeps a GPU busy until it has raised its clocks: whoever let it wait, for an oracle or at the start, calls this.
void warm_up(device::Device&, Loop&);
Sample sample(device::Device&, Loop&, Cache);
std::vector<Sample> samples(device::Device&, Loop&, Cache, uint32_t count);

double median_gpu_ns(const std::vector<Sample>&);  // NaN of none
double median_cpu_ns(const std::vector<Sample>&);
double least_gpu_ns(const std::vector<Sample>&);  // what is possible, others' load aside; infinite of none

}  // namespace assay::report
