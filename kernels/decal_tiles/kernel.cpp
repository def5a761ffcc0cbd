#include "harness/kernel.h"

#include "harness/clusters.h"
#include "harness/groups.h"
#include "kernels/decal_tiles/inputs.h"
#include "kernels/decal_tiles/oracle.h"

namespace assay::decal_tiles {

namespace {

uint64_t cells(const Case& c) {
  const ClusterGrid g = c.params<DecalTileParams>().grid;
  return uint64_t{g.columns} * g.rows * g.slices;
}
uint64_t edges(const Case& c) { return uint64_t{c.params<DecalTileParams>().grid.slices} + 1; }
// Finer levels of the depth pyramid lie before the one that has a texel a tile.
uint64_t ranges(const Case& c) { return c.params<DecalTileParams>().first_range + tiles(c); }

Groups per_64_tiles(const Case& c) { return spread_groups((tiles(c) + 63) / 64); }
Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }
Groups once(const Case&) { return {1}; }

Port only_in(const std::string& variant, Port p) {
  p.only_in = {variant};
  return p;
}

Cost cost_of_lists(const Case& c, uint64_t bytes_of_depths, uint64_t operations) {
  return {.bytes_read = edges(c) * sizeof(float) + cells(c) * sizeof(uvec2) + bytes_of_depths,
          .bytes_written = (tiles(c) + 1) * sizeof(uint) + sizeof(DispatchArgs),
          .operations = operations};
}
// Two slices and a cell or more a tile; a slice and a cell a pixel.
Cost cost_by_range(const Case& c) { return cost_of_lists(c, ranges(c) * sizeof(vec2), tiles(c) * 24); }
Cost cost_by_pixel(const Case& c) { return cost_of_lists(c, pixels(c) * sizeof(float), pixels(c) * 12); }

Variant variant(const std::string& name, std::function<Groups(const Case&)> groups, const std::string& note) {
  std::vector<Bound> bounds = {same_set("tiles", "groups append in any order; past the count nothing is written"),
                               exact("count", "integers and comparisons only"), exact("args", "integers only")};
  for (Bound& b : bounds) b.answer = b.ports[0] + " of " + name;
  return {.name = name,
          .passes = {Clear{"count"}, Dispatch{name + ".comp", std::move(groups)}, Dispatch{"args.comp", once}},
          .bounds = bounds,
          .note = note};
}

std::vector<Variant> variants() {
  std::vector<Variant> all = {variant("hi_z", per_64_tiles, "a thread a tile: all cells between its depths' extremes"),
                              variant("per_pixel", per_tile, "a group a tile: the cells that its pixels are in")};
  all[1].cost = cost_by_pixel;
  return all;
}

}  // namespace

Kernel describe() {
  return {
      .name = "decal_tiles",
      .source = "Lazarek, Hammer 2025, Deferred Dispatches with Tile Classification; Coenen 2020, DOOM Eternal",
      .default_variant = "hi_z",
      .params = layout_of<DecalTileParams>(),
      .ports = {only_in("per_pixel", reads_image("depth", Format::d32_float, {"visibility.depth"})),
                only_in("hi_z", reads<vec2>("ranges", ranges, {"hi_z.ranges"})),
                reads<float>("slice_edges", edges, {"scene.slice_edges"}),
                reads<uvec2>("cells", cells, {"cluster_lists.cells"}), writes<uint>("tiles", tiles),
                writes<uint>("count", fixed(1)), writes<DispatchArgs>("args", fixed(1))},
      .variants = variants(),
      .oracle = listed_tiles,
      .inputs = inputs(),
      .mutants = mutants(),
      .cost = cost_by_range,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .errors = figures_table(),
  };
}

}  // namespace assay::decal_tiles
