#include "harness/kernel.h"

#include <fmt/format.h>

#include "kernels/cluster_voxelization/inputs.h"

namespace assay::cluster_voxelization {

namespace {

uint64_t items(const Case& c) { return item_counts(c).all(); }
uint64_t edges(const Case& c) { return uint64_t{grid_of(c).columns} + grid_of(c).rows + grid_of(c).slices + 3; }
uint64_t planes(const Case& c) { return items(c) * kMaxPlanes; }
uint64_t light_bits(const Case& c) { return words(item_counts(c).lights) * grid_of(c).cells(); }
uint64_t decal_bits(const Case& c) { return words(item_counts(c).decals) * grid_of(c).cells(); }
uint64_t probe_bits(const Case& c) { return words(item_counts(c).probes) * grid_of(c).cells(); }

Groups per_64_items(const Case& c) { return {static_cast<uint32_t>((items(c) + 63) / 64)}; }
Groups per_word_and_slice(const Case& c) {
  const ItemCounts n = item_counts(c);
  return {static_cast<uint32_t>(words(n.lights) + words(n.decals) + words(n.probes)), grid_of(c).slices};
}

Cost cost(const Case& c) {
  const uint64_t bits = light_bits(c) + decal_bits(c) + probe_bits(c);
  return {.bytes_read = items(c) * sizeof(ClusterItem) + edges(c) * sizeof(float),
          .bytes_written = bits * sizeof(uint) + items(c) * sizeof(uvec4) + planes(c) * sizeof(vec4) + sizeof(uint),
          .operations = items(c) * edges(c) * 40};  // which of the grid's planes an item lies beyond
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(ClusterParams{f.scene.lights, 0, 0, f.grid.columns, f.grid.rows, f.grid.slices});
  return c;
}

std::vector<Bound> bounds(const std::string& test, const std::string& reason) {
  std::vector<Bound> all = {exact("dropped_items", "bit patterns")};
  for (const std::string kind : {"light", "decal", "probe"}) {
    all.push_back(bits(kind + "_bits", reason));
    all.back().answer = fmt::format("{}_{}s", test, kind);
  }
  return all;
}

Variant variant(const std::string& test, std::vector<Bound> held_to, const std::string& note) {
  return {.name = test,
          .passes = {Clear{"dropped_items"}, Dispatch{"prepare.comp", per_64_items},
                     Dispatch{"mark_" + test + ".comp", per_word_and_slice}},
          .constants = {{"THREADS", {256, 32}}},
          .bounds = std::move(held_to),
          .note = note};
}

std::vector<Variant> variants() {
  const auto two_way = bounds("two_way", "all that touches; beyond, what no face and no bound keeps away by rounding");
  Variant planes = variant("planes", two_way, "every cell against the item's faces");
  planes.baseline = true;
  return {std::move(planes), variant("two_way", two_way, "the cells within the item's bounds against its faces"),
          variant("separating_axis", bounds("exact", "all that touches; beyond, what rounding cannot tell apart"),
                  "and against the directions square to both one's edges")};
}

}  // namespace

Kernel describe() {
  return {
      .name = "cluster_voxelization",
      .source = "Sousa, Geffroy 2016, Preparing Clustered Shading",
      .default_variant = "two_way",
      .params = layout_of<ClusterParams>(),
      .ports = {reads<ClusterItem>("items", items, {"scene.cluster_items"}),
                reads<float>("edges", edges, {"scene.cluster_edges"}), writes<uvec4>("item_bounds", items),
                writes<vec4>("item_planes", planes), writes<uint>("dropped_items", fixed(1)),
                writes<uint>("light_bits", light_bits), writes<uint>("decal_bits", decal_bits),
                writes<uint>("probe_bits", probe_bits)},
      .variants = variants(),
      .oracle = mark,
      .inputs = inputs(),
      .bounds = bounds("two_way", "as of the variant"),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{1280, 720}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .undecided_limit = 1e-3,
      .undecided_reason =
          "items laid on corners of cells have 6e-3, spots of 89 degrees 1.6e-3; all others are under 1e-4",
      .errors = error_table(),
  };
}

}  // namespace assay::cluster_voxelization
