#include "harness/kernel.h"

#include "kernels/tile_visit/inputs.h"
#include "kernels/tile_visit/oracle.h"

namespace assay::tile_visit {

namespace {

uint64_t entries(const Case& c) { return tiles(c) * workloads(c); }

Cost cost(const Case& c) {
  return {.bytes_read = entries(c) * sizeof(uint) + workloads(c) * (sizeof(WorkloadCount) + sizeof(DispatchArgs)),
          .bytes_written = pixels(c) * sizeof(uint),
          .operations = pixels(c)};  // an addition a pixel where each is visited once
}

}  // namespace

Kernel describe() {
  return {
      .name = "tile_visit",
      .source = "Lazarek, Hammer 2025, Deferred Dispatches with Tile Classification: workload dispatch",
      .default_variant = "indirect",
      .params = layout_of<VisitParams>(),
      .ports = {reads<uint>("workload_tiles", entries, {"tile_classification.workload_tiles"}),
                reads<WorkloadCount>("workload_counts", workloads, {"tile_classification.workload_counts"}),
                reads<DispatchArgs>("workload_args", workloads, {"tile_classification.workload_args"}),
                writes<uint>("visits", pixels)},
      .variants = {{.name = "indirect",
                    .passes = {Clear{"visits"},
                               Dispatch{.shader = "visit.comp", .indirect = "workload_args", .repeat = workloads}},
                    .note = "an indirect dispatch a workload, tiles by 1D index"}},
      .oracle = visit,
      .inputs = inputs(),
      .bounds = {exact("visits", "integers only")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
  };
}

}  // namespace assay::tile_visit
