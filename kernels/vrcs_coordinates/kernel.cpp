#include "harness/kernel.h"

#include "harness/groups.h"
#include "kernels/vrcs_coordinates/inputs.h"
#include "kernels/vrcs_coordinates/oracle.h"

namespace assay::vrcs_coordinates {

namespace {

Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }
Groups once(const Case&) { return {1}; }

Port rates() {
  Port port = reads_image("rates", Format::r8_uint, {"vrcs_shading_rate.rates"});
  port.extent = cells;
  return port;
}
Port only_in(const std::string& variant, Port port) {
  port.only_in = {variant};
  return port;
}

std::vector<Bound> bounds(const std::string& rule) {
  std::vector<Bound> all = {
      exact("tiles", "integers only"),
      exact("entries", "integers only, in the order of lanes; past a list's end nothing is written"),
      exact("copy_bits", "integers only")};
  for (Bound& b : all) b.answer = b.ports[0] + rule;
  return all;
}

Variant sharing(const std::string& rule, const std::string& note) {
  return {.name = rule, .passes = {Dispatch{rule + ".comp", per_tile}}, .bounds = bounds(" of " + rule), .note = note};
}

std::vector<Bound> with_depth() {
  std::vector<Bound> all = bounds("");
  all[1] = between({"entries"},
                   "coordinates and copy bits exact; depth's code within the roundings of a division (2.5 "
                   "ulp), a difference, a product and a sum");
  all[1].unpack = Unpack{layout_of<DepthEntry>(), unpack_depth_entries};
  all[1].answer = "depth_entries";
  return all;
}

std::vector<Bound> with_list() {
  std::vector<Bound> all = bounds("");
  all.push_back(same_set("list", "a tile's primaries are in order, tiles append in any"));
  all.push_back(exact("list_count", "integers only"));
  all.push_back(exact("list_args", "integers only"));
  return all;
}

Cost cost(const Case& c) {
  return {
      .bytes_read = pixel_count(cells(c)) + pixels(c) * (sizeof(uvec2) + sizeof(float)),
      .bytes_written = (tiles(c) + entries(c)) * sizeof(uint) + pixels(c),
      .operations = pixels(c) * 8};  // of a pixel: covered, three comparisons, fog, its bits' place and two packings
}

}  // namespace

Kernel describe() {
  return {
      .name = "vrcs_coordinates",
      .source = "Fuller, Hammer 2025, Variable-Rate Compute Shaders: coordinate remapping",
      .default_variant = "tile_list",
      .params = layout_of<VrcsParams>(),
      .ports = {rates(), reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads_image("depth", Format::d32_float, {"visibility.depth"}),
                only_in("stored_normal", reads_image("face_normals", Format::rg16_snorm, {"visibility.face_normals"})),
                writes<uint>("tiles", tiles), writes<uint>("entries", entries),
                writes_image("copy_bits", Format::r8_uint), only_in("compact", writes<uint>("list", pixels)),
                only_in("compact", writes<uint>("list_count", fixed(1))),
                only_in("compact", writes<DispatchArgs>("list_args", fixed(1)))},
      .variants = {{.name = "tile_list",
                    .passes = {Dispatch{"tile_list.comp", per_tile}},
                    .note = "pixels share within a triangle; a list a tile"},
                   {.name = "depth_entries",
                    .passes = {Dispatch{"depth_entries.comp", per_tile}},
                    .bounds = with_depth(),
                    .note = "the spare 21 bits of an entry hold the view depth"},
                   {.name = "compact",
                    .passes = {Clear{"list_count"}, Dispatch{"compact.comp", per_tile},
                               Dispatch{"list_args.comp", once}},
                    .bounds = with_list(),
                    .note = "and all primaries of the screen in one list"},
                   sharing("stored_normal", "triangles share where their stored normals and the depths are close"),
                   sharing("rebuilt_normal", "likewise, by normals rebuilt from the depths of three pixels"),
                   sharing("same_surface", "triangles share where they are of one surface and the depths are close")},
      .oracle = coordinates,
      .inputs = inputs(),
      .bounds = bounds(""),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .errors = figures_table(),
  };
}

}  // namespace assay::vrcs_coordinates
