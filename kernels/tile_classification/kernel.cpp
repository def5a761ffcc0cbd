#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/tile_classification/inputs.h"
#include "kernels/tile_classification/oracle.h"

namespace assay::tile_classification {

namespace {

uint64_t list_entries(const Case& c) { return tiles(c) * live_workloads(c); }
Groups per_pixel(const Case& c) { return spread_groups((pixels(c) + 255) / 256); }
Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }
Groups per_256_tiles(const Case& c) { return {static_cast<uint32_t>((tiles(c) + 255) / 256)}; }
Groups once(const Case&) { return {1}; }

// The passes of a variant: its own marking, then what all share.
std::vector<Pass> after(std::vector<Pass> marking) {
  marking.insert(marking.end(),
                 {Clear{"workload_counts"}, Dispatch{"gather.comp", per_256_tiles}, Dispatch{"args.comp", once}});
  return marking;
}

Cost cost(const Case& c) {
  const uint64_t w = live_workloads(c), p = live_passes(c);
  return {.bytes_read = pixels(c) * sizeof(uint) + w * sizeof(Workload),
          .bytes_written = tiles(c) * sizeof(uint) + list_entries(c) * sizeof(uint) +
                           w * (sizeof(WorkloadCount) + sizeof(DispatchArgs)) + p * sizeof(PassStatistics),
          .operations = pixels(c) + tiles(c) * (p + 4 * w)};  // an OR a pixel; a test a pass, four operations a row
}

}  // namespace

Kernel describe() {
  return {
      .name = "tile_classification",
      .source = "Lazarek, Hammer 2025, Deferred Dispatches with Tile Classification",
      .default_variant = "subgroup_or",
      .params = layout_of<ClassifyParams>(),
      .ports = {reads<uint>("features", pixels,
                            {"gbuffer_update.features", "deferred_texturing.features", "material_features.features"}),
                reads<Workload>("workloads", live_workloads), writes<uint>("masks", tiles),
                writes<uint>("workload_tiles", list_entries), writes<WorkloadCount>("workload_counts", live_workloads),
                writes<DispatchArgs>("workload_args", live_workloads),
                writes<PassStatistics>("statistics", live_passes)},
      .variants = {{.name = "atomic",
                    .passes = after({Clear{"masks"}, Dispatch{"mark_atomic.comp", per_pixel}}),
                    .note = "an atomic OR a pixel"},
                   {.name = "scalarised",
                    .passes = after({Clear{"masks"}, Dispatch{"mark_scalarised.comp", per_pixel}}),
                    .needs = {Feature::subgroup_ballot, Feature::subgroup_arithmetic},
                    .note = "an atomic OR a subgroup and tile, as passes do that know their features"},
                   {.name = "tile_reduce",
                    .passes = after({Dispatch{"mark_reduce.comp", per_tile}}),
                    .constants = {{"THREADS", {64, 256, 1024}}},
                    .note = "a group a tile, a tree in shared memory, one store"},
                   {.name = "subgroup_or",
                    .passes = after({Dispatch{"mark_subgroup.comp", per_tile}}),
                    .constants = {{"THREADS", {64, 256}}},
                    .needs = {Feature::subgroup_arithmetic},
                    .note = "a group a tile, an OR a subgroup, one shared atomic each, one store"}},
      .oracle = classify,
      .inputs = inputs(),
      .bounds = {exact("masks", "integers only"), same_set("workload_tiles", "tiles append in any order"),
                 exact("workload_counts", "integers only"), exact("workload_args", "integers only"),
                 exact("statistics", "integers only, saturated")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
  };
}

}  // namespace assay::tile_classification
