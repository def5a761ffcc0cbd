#include "harness/kernel.h"

#include <algorithm>

#include "harness/clusters.h"
#include "kernels/cluster_lists/inputs.h"
#include "kernels/cluster_lists/oracle.h"

namespace assay::cluster_lists {

namespace {

uint32_t words(uint32_t items, uint32_t most) { return ceil_div(std::min(items, most), 32); }
uint64_t cells(const Case& c) { return std::min(c.params<ListParams>().cells, kMaxCells); }
uint64_t light_bits(const Case& c) { return cells(c) * words(c.params<ListParams>().lights, kMaxClusterLights); }
uint64_t decal_bits(const Case& c) { return cells(c) * words(c.params<ListParams>().decals, kMaxClusterDecals); }
uint64_t probe_bits(const Case& c) { return cells(c) * words(c.params<ListParams>().probes, kMaxClusterProbes); }
uint64_t blocks(const Case& c) { return (cells(c) + kBlock - 1) / kBlock; }
uint64_t capacity(const Case& c) { return c.params<ListParams>().capacity; }

// Groups of as many cells.
std::function<Groups(const Case&)> per(uint32_t cells_of_a_group) {
  return [=](const Case& c) { return Groups{ceil_div(static_cast<uint32_t>(cells(c)), cells_of_a_group)}; };
}

// What must be moved at least: lists as long as their room. The bits are read twice.
Cost cost(const Case& c) {
  const uint64_t bits = light_bits(c) + decal_bits(c) + probe_bits(c);
  return {
      .bytes_read = bits * sizeof(uint),
      .bytes_written = cells(c) * sizeof(uvec2) + (blocks(c) + capacity(c)) * sizeof(uint) + sizeof(ClusterListStatus),
      .operations = 4 * bits};
}

Variant variant(const std::string& name, uint32_t cells_of_a_group, const std::string& note) {
  return {.name = name,
          .passes = {Clear{"list_status"}, Dispatch{"count_" + name + ".comp", per(cells_of_a_group)},
                     Dispatch{"sum.comp", per(kBlock)}, Dispatch{"place.comp", per(kBlock)},
                     Dispatch{"write_" + name + ".comp", per(cells_of_a_group)}},
          .note = note};
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  const uint32_t all = f.grid.columns * f.grid.rows * f.grid.slices;
  c.set_params(ListParams{f.scene.lights, f.decals.decals, 0, all, list_capacity(f.grid)});
  return c;
}

}  // namespace

Kernel describe() {
  return {
      .name = "cluster_lists",
      .source = "Sousa, Geffroy 2016, Preparing Clustered Shading: the list of items and the cells' offsets into it",
      .default_variant = "thread",
      .params = layout_of<ListParams>(),
      .ports = {reads<uint>("light_bits", light_bits, {"cluster_voxelization.light_bits"}),
                reads<uint>("decal_bits", decal_bits, {"cluster_voxelization.decal_bits"}),
                reads<uint>("probe_bits", probe_bits, {"cluster_voxelization.probe_bits"}),
                writes<uvec2>("cells", cells), writes<uint>("block_entries", blocks),
                writes<ClusterListStatus>("list_status", fixed(1)), writes<uint>("entries", capacity)},
      .variants = {variant("thread", 64, "a thread a cell"), variant("team", 8, "32 threads a cell, a word each")},
      .oracle = lists,
      .inputs = inputs(),
      .bounds = {exact("cells", "integers only; offsets are sums in the cells' order"),
                 exact("entries", "integers only, ascending"), exact("block_entries", "integers only"),
                 exact("list_status", "integers only; sums in any order")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::cluster_lists
