#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/vrcs_remap/inputs.h"
#include "kernels/vrcs_remap/oracle.h"

namespace assay::vrcs_remap {

namespace {

Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }

Port only_in(std::vector<std::string> variants, Port port) {
  port.only_in = std::move(variants);
  return port;
}
Port of_tiles(Port port) { return only_in({"tile_list", "tile_list_fog"}, std::move(port)); }
Port of_list(Port port) { return only_in({"compact"}, std::move(port)); }

Variant variant(const std::string& name, Dispatch visit, const std::string& note) {
  std::vector<Bound> bounds = {exact("visits", "a count of stores"),
                               exact("values", "integers only, the largest stored"),
                               exact("waves", "a count of subgroups with work")};
  for (Bound& b : bounds) b.answer = b.ports[0] + " of " + name;
  return {.name = name,
          .passes = {Clear{"visits"}, Clear{"values"}, Clear{"waves"}, std::move(visit)},
          .subgroup_min = 4,
          .bounds = bounds,
          .note = note};
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * sizeof(uvec2) + (tiles(c) + entries(c)) * sizeof(uint),
          .bytes_written = (2 * pixels(c) + tiles(c)) * sizeof(uint),
          .operations = pixels(c) * 4};  // a place, which is two, a comparison and a count
}

}  // namespace

Kernel describe() {
  return {
      .name = "vrcs_remap",
      .source = "Fuller, Hammer 2025, Variable-Rate Compute Shaders: VRCSPrefix, VRCSPostFix, pixel commands",
      .default_variant = "tile_list",
      .params = layout_of<RemapParams>(),
      .ports = {of_tiles(reads_image("visibility", Format::rg32_uint, {"visibility.visibility"})),
                of_tiles(reads<uint>("tiles", tiles, {"vrcs_coordinates.tiles"})),
                of_tiles(reads<uint>("entries", entries, {"vrcs_coordinates.entries"})),
                of_list(reads<uint>("list", pixels, {"vrcs_coordinates.list"})),
                of_list(reads<uint>("list_count", fixed(1), {"vrcs_coordinates.list_count"})),
                of_list(reads<DispatchArgs>("list_args", fixed(1), {"vrcs_coordinates.list_args"})),
                writes<uint>("values", pixels), writes<uint>("visits", pixels), writes<uint>("waves", tiles)},
      .variants = {variant("tile_list", {"tile_list.comp", per_tile}, "a group a tile, a lane an entry"),
                   variant("tile_list_fog", {"tile_list_fog.comp", per_tile}, "and all pixels of fogged tiles"),
                   variant("compact", {.shader = "compact.comp", .indirect = "list_args"},
                           "a thread an entry of the screen's list")},
      .oracle = remap,
      .inputs = inputs(),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::vrcs_remap
