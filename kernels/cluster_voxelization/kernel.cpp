#include "harness/kernel.h"

#include <fmt/format.h>

#include "harness/clusters.h"
#include "kernels/cluster_voxelization/inputs.h"

namespace assay::cluster_voxelization {

namespace {

uint64_t items(const Case& c) { return item_counts(c).all(); }
uint64_t edges(const Case& c) { return uint64_t{grid_of(c).columns} + grid_of(c).rows + grid_of(c).slices + 3; }
uint64_t planes(const Case& c) { return items(c) * kMaxPlanes; }
uint64_t outline_planes(const Case& c) { return items(c) * kMaxOutline; }
// Finer levels of the depth pyramid lie before the one that has a texel a column and row.
uint64_t depth_ranges(const Case& c) {
  return c.params<ClusterParams>().first_range + uint64_t{grid_of(c).columns} * grid_of(c).rows;
}
// Of columns, and of bins and slices.
uint64_t lists(const Case& c) {
  const Grid g = grid_of(c);
  return uint64_t{g.columns} * g.rows + uint64_t{ceil_div(g.columns, kBinSide)} * ceil_div(g.rows, kBinSide) * g.slices;
}
uint64_t list_lengths(const Case& c) { return 3 * lists(c); }
uint64_t light_bits(const Case& c) { return words(item_counts(c).lights) * grid_of(c).cells(); }
uint64_t decal_bits(const Case& c) { return words(item_counts(c).decals) * grid_of(c).cells(); }
uint64_t probe_bits(const Case& c) { return words(item_counts(c).probes) * grid_of(c).cells(); }

Groups per_64_items(const Case& c) { return {static_cast<uint32_t>((items(c) + 63) / 64)}; }
uint32_t all_words(const Case& c) {
  const ItemCounts n = item_counts(c);
  return static_cast<uint32_t>(words(n.lights) + words(n.decals) + words(n.probes));
}
Groups per_word_and_slice(const Case& c) { return {all_words(c), grid_of(c).slices}; }
uint64_t list_bits(const Case& c) { return all_words(c) * lists(c); }
Groups per_word_and_64_cells(const Case& c) {
  return {static_cast<uint32_t>((grid_of(c).cells() + 63) / 64), all_words(c)};
}
Groups per_word_and_bin(const Case& c) {
  return {all_words(c), ceil_div(grid_of(c).columns, kBinSide) * ceil_div(grid_of(c).rows, kBinSide)};
}

Cost cost(const Case& c) {
  const uint64_t bits = light_bits(c) + decal_bits(c) + probe_bits(c);
  return {.bytes_read = items(c) * sizeof(ClusterItem) + edges(c) * sizeof(float),
          .bytes_written = bits * sizeof(uint) + items(c) * (sizeof(uvec4) + sizeof(Outline)) +
                           (planes(c) + outline_planes(c)) * sizeof(vec4) + sizeof(uint),
          .operations = items(c) * edges(c) * 40};  // which of the grid's planes an item lies beyond
}

// The pyramid's fifth level has a texel a cell of 32 pixels; of other cells depths say nothing.
Case in_frame(const FrameInputs& f) {
  constexpr uint kLevel = 5;
  const ClusterGrid& g = f.grid;
  Case c = {.name = "frame", .extent = f.extent};
  const bool has_depths = g.cell_width == 1u << kLevel && g.cell_height == 1u << kLevel;
  c.set_params(ClusterParams{f.scene.lights, f.decals.decals, 0, g.columns, g.rows, g.slices,
                             has_depths ? f.near_plane : 0, has_depths ? first_of_level(f.extent, kLevel) : 0});
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

Variant variant(const std::string& name, std::vector<Pass> mark, std::vector<Bound> held_to, const std::string& note) {
  std::vector<Pass> passes = {Clear{"dropped_items"}, Dispatch{"prepare.comp", per_64_items}};
  passes.insert(passes.end(), mark.begin(), mark.end());
  return {.name = name,
          .passes = std::move(passes),
          .constants = {{"THREADS", {256, 32}}},
          .bounds = std::move(held_to),
          .note = note};
}

std::vector<Variant> variants() {
  const auto two_way = bounds("two_way", "all that touches; beyond, what no face and no bound keeps away by rounding");
  const auto marked = [](const std::string& shader, Groups (*groups)(const Case&)) -> std::vector<Pass> {
    return {Dispatch{shader, groups}};
  };
  const auto outlined = [](const std::string& shader) -> std::vector<Pass> {
    return {Dispatch{"outline.comp", per_64_items}, Dispatch{shader, per_word_and_bin}};
  };
  std::vector<Variant> all = {
      variant("planes", marked("mark_planes.comp", per_word_and_slice), two_way, "every cell against the item's faces"),
      variant("two_way", marked("mark_two_way.comp", per_word_and_slice), two_way,
              "the cells within the item's bounds against its faces"),
      variant("separating_axis", marked("mark_separating_axis.comp", per_word_and_slice),
              bounds("exact", "all that touches; beyond, what rounding cannot tell apart"),
              "and against the directions square to both one's edges"),
      variant("hexahedra_raster", outlined("mark_hexahedra.comp"),
              bounds("hexahedra", "all that touches; beyond, what no face, no outline and no depth keeps away"),
              "columns within the item's outline, in bins first; of each, the slices between its faces"),
      variant("hexahedra_hi_z", outlined("mark_hexahedra_hi_z.comp"),
              bounds("hi_z", "all that touches a cell's part between the column's surfaces; beyond, as without"),
              "and between the nearest and the farthest surface of the column"),
      variant("two_pass_raster", marked("mark_two_pass.comp", per_word_and_bin),
              bounds("two_pass", "all that touches; beyond, what lies between the faces' slices in a column"),
              "faces that look away store the farthest slice, those that look at the eye walk there"),
      variant("smaller_list",
              {Clear{"list_lengths"}, Dispatch{"outline.comp", per_64_items},
               Dispatch{"tile_lists.comp", per_word_and_bin}, Dispatch{"smaller_list.comp", per_word_and_64_cells}},
              bounds("smaller", "all that touches a cell's part between the column's surfaces; beyond, of either list"),
              "the shorter of a column's list at its surfaces' depths and that of a bin of 8x8 columns and a slice")};
  all.front().baseline = true;
  all[5].constants = {{"THREADS", {256, 64}}};
  return all;
}

std::vector<Port> ports() {
  std::vector<Port> all = {reads<ClusterItem>("items", items, {"scene.cluster_items"}),
                           reads<float>("edges", edges, {"scene.cluster_edges"}),
                           reads<vec2>("depth_ranges", depth_ranges, {"hi_z.ranges"}),
                           writes<uvec4>("item_bounds", items),
                           writes<vec4>("item_planes", planes),
                           writes<Outline>("outlines", items),
                           writes<vec4>("outline_planes", outline_planes),
                           writes<uint>("dropped_items", fixed(1)),
                           writes<uint>("list_bits", list_bits),
                           writes<uint>("list_lengths", list_lengths),
                           writes<uint>("light_bits", light_bits),
                           writes<uint>("decal_bits", decal_bits),
                           writes<uint>("probe_bits", probe_bits)};
  all[2].only_in = {"hexahedra_hi_z", "smaller_list"};
  all[5].only_in = all[6].only_in = {"hexahedra_raster", "hexahedra_hi_z", "smaller_list"};
  all[8].only_in = all[9].only_in = {"smaller_list"};
  return all;
}

}  // namespace

Kernel describe() {
  return {
      .name = "cluster_voxelization",
      .source = "Sousa, Geffroy 2016, Preparing Clustered Shading; Coenen 2020, DOOM Eternal; Pettineo 2016, clusters",
      .default_variant = "hexahedra_raster",
      .params = layout_of<ClusterParams>(),
      .ports = ports(),
      .variants = variants(),
      .oracle = mark,
      .inputs = inputs(),
      .bounds = bounds("hexahedra", "as of the variant"),
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
