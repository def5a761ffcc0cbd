#include <algorithm>

#include "harness/formats/vrcs.h"
#include "harness/formats/workloads.h"
#include "harness/groups.h"
#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/layout.h"
#include "kernels/deferred_lighting/oracle.h"

namespace assay::deferred_lighting {
namespace {

Groups per_tile(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
Groups per_tile_in_rows(const Case& c) { return spread_groups(tile_count(c.extent, kVrcsTileSide)); }
uint64_t lights(const Case& c) { return c.params<LightingParams>().lights; }
uint64_t cells(const Case& c) {
  const ClusterGrid g = c.params<LightingParams>().grid;
  return uint64_t{g.columns} * g.rows * g.slices;
}
uint64_t entries(const Case& c) { return c.params<LightingParams>().entries; }
uint64_t slice_edges(const Case& c) { return uint64_t{c.params<LightingParams>().grid.slices} + 1; }

uint64_t shadow_views(const Case& c) { return c.params<LightingParams>().shadow_views; }
Extent shadow_extent(const Case& c) {
  return {c.params<LightingParams>().shadow_width, c.params<LightingParams>().shadow_height};
}

uint64_t tiles(const Case& c) { return tile_count(c.extent, kVrcsTileSide); }
uint64_t tile_entries(const Case& c) { return tiles(c) * kVrcsTileEntries; }

// Bytes of the ports, and 150 operations of a light at a pixel, as the shader counts them.
uint64_t bytes_of_pixels(const Case& c) {
  return pixels(c) * (4 + 4 + 4 + 2 + 4 + 4) + lights(c) * sizeof(LightRecord);
}
uint64_t bytes_of_cells(const Case& c) {
  return cells(c) * sizeof(uvec2) + entries(c) * sizeof(uint) + slice_edges(c) * sizeof(float);
}
uint64_t bytes_of_tiles(const Case& c) {
  return pixels(c) * sizeof(uvec2) + (tiles(c) + tile_entries(c)) * sizeof(uint);
}
uint64_t bytes_of_list(const Case& c) {
  return pixels(c) * (sizeof(uvec2) + sizeof(uint)) + sizeof(uint) + sizeof(DispatchArgs);
}
uint64_t bytes_of_shadows(const Case& c) {
  return pixels(c) * 4 + shadow_views(c) * sizeof(ShadowView) + pixel_count(shadow_extent(c)) * sizeof(float);
}
uint64_t lights_a_cell(const Case& c) { return entries(c) / std::max<uint64_t>(cells(c), 1); }

uint64_t shaded_by_tiles(const Case& c) {
  uint64_t shaded = 0;
  for (const uint word : c.input<uint>("tiles"))
    shaded += (word & kVrcsTileCount) > kVrcsTileEntries ? kVrcsTilePixels : word & kVrcsTileCount;
  return shaded;
}

Cost cost_of_reads(const Case& c, uint64_t bytes_read, uint64_t shaded, uint64_t lights_a_pixel) {
  return {.bytes_read = bytes_read, .bytes_written = pixels(c) * 8, .operations = shaded * (60 + 150 * lights_a_pixel)};
}
Cost cost(const Case& c) {
  return cost_of_reads(c, bytes_of_pixels(c) + bytes_of_cells(c), pixels(c), lights_a_cell(c));
}
Cost cost_of_plain(const Case& c) { return cost_of_reads(c, bytes_of_pixels(c), pixels(c), lights(c)); }
Cost cost_of_tiles(const Case& c) {
  return cost_of_reads(c, bytes_of_pixels(c) + bytes_of_cells(c) + bytes_of_tiles(c), shaded_by_tiles(c),
                       lights_a_cell(c));
}
Cost cost_of_plain_tiles(const Case& c) {
  return cost_of_reads(c, bytes_of_pixels(c) + bytes_of_tiles(c), shaded_by_tiles(c), lights(c));
}
Cost cost_of_list(const Case& c) {
  return cost_of_reads(c, bytes_of_pixels(c) + bytes_of_cells(c) + bytes_of_list(c), c.input<uint>("list_count")[0],
                       lights_a_cell(c));
}

// With shadows: a lookup of 3x3 taps has 220 operations beside the 150 of its light.
std::function<Cost(const Case&)> in_shadow(std::function<Cost(const Case&)> unshadowed) {
  return [unshadowed = std::move(unshadowed)](const Case& c) {
    Cost all = unshadowed(c);
    uint64_t casting = 0;
    for (const LightRecord& light : c.input<LightRecord>("lights")) casting += light.views > 0;
    all.bytes_read += bytes_of_shadows(c);
    all.operations += all.operations * 220 * casting / (150 * std::max<uint64_t>(lights(c), 1));
    return all;
  };
}

// Both producers of a channel of the G-buffer; the update, where there is one, made the latest version.
std::vector<std::string> of_gbuffer(const std::string& channel) {
  return {"decal_atlas_sampling." + channel, "deferred_texturing." + channel};
}

const char* const kReason =
    "running error of fp32 by Vulkan's table (README, Bounds), then either neighbouring half; alpha exact";

Bound radiance(const std::string& reason) {
  Bound bound = between({"radiance"}, reason);
  bound.unpack = Unpack{texel_layout(), unpack_texels};
  return bound;
}

std::vector<Port> ports() {
  std::vector<Port> all = {reads_image("depth", Format::d32_float, {"visibility.depth"}),
                           reads_image("base_roughness", Format::rgba8_unorm, of_gbuffer("base_roughness")),
                           reads_image("normal", Format::rg16_snorm, of_gbuffer("normal")),
                           reads_image("metallic_occlusion", Format::rg8_unorm, of_gbuffer("metallic_occlusion")),
                           reads_image("emissive", Format::r32_uint, of_gbuffer("emissive")),
                           reads<uint>("features", pixels, of_gbuffer("features")),
                           reads<LightRecord>("lights", lights, {"scene.lights"}),
                           writes_image("radiance", Format::rgba16_float)};
  const auto add = [&all](const std::vector<std::string>& variants, std::vector<Port> some) {
    for (Port& p : some) {
      p.only_in = variants;
      all.push_back(std::move(p));
    }
  };
  add({"clustered", "clustered_scalarised", "clustered_tile_list", "clustered_list", "clustered_shadowed",
       "clustered_tile_list_shadowed"},
      {reads<uvec2>("cells", cells, {"cluster_lists.cells"}),
       reads<uint>("entries", entries, {"cluster_lists.entries"}),
       reads<float>("slice_edges", slice_edges, {"scene.slice_edges"})});
  add({"clustered_tile_list", "plain_tile_list", "clustered_list", "clustered_tile_list_shadowed",
       "plain_tile_list_shadowed"},
      {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"})});
  add({"clustered_tile_list", "plain_tile_list", "clustered_tile_list_shadowed", "plain_tile_list_shadowed"},
      {reads<uint>("tiles", tiles, {"vrcs_coordinates.tiles"}),
       reads<uint>("tile_entries", tile_entries, {"vrcs_coordinates.entries"})});
  add({"clustered_list"}, {reads<uint>("list", pixels, {"vrcs_coordinates.list"}),
                           reads<uint>("list_count", fixed(1), {"vrcs_coordinates.list_count"}),
                           reads<DispatchArgs>("list_args", fixed(1), {"vrcs_coordinates.list_args"})});
  Port shadow_depth = reads_image("shadow_depth", Format::d32_float, {"shadow_atlas.depth"});
  shadow_depth.extent = shadow_extent;
  add({"plain_shadowed", "clustered_shadowed", "plain_tile_list_shadowed", "clustered_tile_list_shadowed"},
      {reads<ShadowView>("shadow_views", shadow_views, {"scene.shadow_views"}), shadow_depth,
       reads_image("depth_gradients", Format::rg16_float, {"depth_gradients.gradients"})});
  return all;
}

Variant clustered(const std::string& name, std::vector<Feature> needs, const std::string& note) {
  Bound bound = radiance("of the lights in the cell's list: as of all");
  bound.answer = "clustered_radiance";
  return {.name = name,
          .passes = {Dispatch{name + ".comp", per_tile}},
          .needs = std::move(needs),
          .bounds = std::vector<Bound>{bound},
          .note = note};
}

Variant of_primaries(const std::string& name, std::vector<Pass> passes, std::function<Cost(const Case&)> cost,
                     const std::string& note) {
  Bound bound = radiance("a copy is its primary's texel, bounded as that pixel alone");
  bound.answer = name;
  return {.name = name,
          .passes = std::move(passes),
          .subgroup_min = 4,
          .bounds = std::vector<Bound>{bound},
          .cost = std::move(cost),
          .note = note};
}

// The same as a variant, and what the shadow atlas lets through.
Variant with_shadows(Variant v, std::function<Cost(const Case&)> cost) {
  v.name += "_shadowed";
  std::get<Dispatch>(v.passes.at(0)).shader = v.name + ".comp";
  Bound bound = radiance("a tap's comparison within fp32's running error (kernels/shadow_lookup); else as without");
  bound.answer = v.name;
  v.bounds = std::vector<Bound>{bound};
  v.cost = in_shadow(std::move(cost));
  v.note += "; 3x3 taps of each shadow";
  return v;
}

std::vector<Variant> variants() {
  const Variant plain = {
      .name = "plain", .passes = {Dispatch{"plain.comp", per_tile}}, .note = "each pixel walks all lights"};
  const Variant by_cell = clustered("clustered", {}, "each pixel walks the lights of its cell");
  const Variant tiles = of_primaries("clustered_tile_list", {Dispatch{"clustered_tile_list.comp", per_tile_in_rows}},
                                     cost_of_tiles, "a group a tile of 16x16 shades its primaries and copies");
  const Variant plain_tiles = of_primaries("plain_tile_list", {Dispatch{"plain_tile_list.comp", per_tile_in_rows}},
                                           cost_of_plain_tiles, "the same by all lights");
  return {plain,
          {.name = "tiled_shared",
           .passes = {Dispatch{"tiled_shared.comp", per_tile}},
           .note = "a group fetches lights once, through shared memory"},
          {.name = "subgroup_cull",
           .passes = {Dispatch{"subgroup_cull.comp", per_tile}},
           .needs = {Feature::subgroup_ballot, Feature::subgroup_arithmetic},
           .note = "a wave leaves out lights whose range its pixels' box is beyond"},
          by_cell,
          clustered("clustered_scalarised", {Feature::subgroup_ballot, Feature::subgroup_arithmetic},
                    "a wave walks the lights of its cells together, in one cell without asking"),
          tiles,
          plain_tiles,
          of_primaries("clustered_list",
                       {Dispatch{"background.comp", per_tile},
                        Dispatch{.shader = "clustered_list.comp", .indirect = "list_args"}},
                       cost_of_list, "a thread a primary of the screen's list, after the background"),
          with_shadows(plain, cost_of_plain),
          with_shadows(by_cell, cost),
          with_shadows(tiles, cost_of_tiles),
          with_shadows(plain_tiles, cost_of_plain_tiles)};
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "the last column is not on the screen", "odd_extent"},
          {"common.glsl", 2, "a pixel's corner for its centre", "one_pixel"},
          {"common.glsl", 3, "depth taken for distance", "light_at_the_surface"},
          {"common.glsl", 4, "ambient light without occlusion", "no_light"},
          {"common.glsl", 5, "neither held above 0 nor below infinity", "negative_light"},
          {"common.glsl", 6, "the background is left as it was", "background"},
          {"all_lights.glsl", 7, "the last light is left out", "one_pixel"},
          {"tiled_shared.comp", 8, "the first barrier dropped", "one_light_over_two_batches"},
          {"tiled_shared.comp", 9, "a whole batch though fewer lights are left", "one_light_over_two_batches"},
          {"tiled_shared.comp", 10, "the second barrier dropped", "many_lights"},
          {"subgroup_cull.comp", 11, "lights are left out at half their range", "range_edge"},
          {"subgroup_cull.comp", 12, "the first lane's box for the wave's", "light_in_one_pixel"},
          {"subgroup_cull.comp", 13, "every light taken for the first of its round", "many_lights"},
          {"lists.glsl", 14, "the last light is not there", "cells_of_one_light"},
          {"harness/glsl/light_lists_own.glsl", 9831, "a list's first light is left out", "cells_of_one_light"},
          {"harness/glsl/light_lists_scalarised.glsl", 9832, "the first lane's light for the least of all",
           "cells_within_a_wave"},
          {"harness/glsl/light_lists_scalarised.glsl", 9833, "a wave of two cells taken for one of the first",
           "cells_within_a_wave"},
          {"covered.glsl", 18, "the depth is asked what is covered", "covered_elsewhere"},
          {"primaries.glsl", 19, "a primary without depth is left as it was", "covered_elsewhere"},
          {"tile_list.glsl", 20, "a tile is full by its flag alone", "full_by_flag"},
          {"tile_list.glsl", 21, "background in sky tiles alone", "one_pixel_of_sky"},
          {"tile_list.glsl", 22, "where all are to be shaded, none is", "primaries_225"},
          {"clustered_list.comp", 23, "one row of groups", "rows_of_groups"},
          {"clustered_list.comp", 24, "the last thread of a group has nothing to do", "all_2x2"},
          {"background.comp", 25, "the background ends with whole groups", "one_pixel_of_sky"},
          {"common.glsl", 26, "every plane faces the eye", "leaning_planes"},
          {"common.glsl", 27, "planes lean the other way", "leaning_planes"},
          {"common.glsl", 28, "the dither is every frame the same", "dithered_cascades"},
          {"harness/glsl/vrcs.glsl", 9601, "lists are trusted", "entries_off_screen"},
          {"harness/glsl/vrcs.glsl", 9602, "the last list that saves a wave is not taken", "primaries_224"},
          {"harness/glsl/vrcs.glsl", 9603, "one lane too many", "all_2x1"},
          {"harness/glsl/vrcs.glsl", 9604, "the upper left pixel in every frame", "all_2x2_odd_frame"},
          {"harness/glsl/vrcs.glsl", 9606, "the diagonal is forgotten", "all_2x2"},
          {"harness/glsl/clusters.glsl", 9401, "a depth on a boundary is in the slice before", "depths_on_slices"},
          {"harness/glsl/clusters.glsl", 9402, "columns as wide as rows are high", "cells_of_one_light"},
          {"harness/glsl/gbuffer.glsl", 9302, "normals of the lower half stay folded", "every_normal"},
          {"harness/glsl/gbuffer.glsl", 9304, "emission twice as bright", "emission"},
          {"harness/glsl/gbuffer.glsl", 9306, "the root of the base colour taken for it", "no_light"},
          {"harness/glsl/lighting.glsl", 9201, "roughness has no floor", "smoothest"},
          {"harness/glsl/lighting.glsl", 9202, "roughness not squared", "every_roughness"},
          {"harness/glsl/lighting.glsl", 9203, "the square for the fourth power at the range's end", "range_edge"},
          {"harness/glsl/lighting.glsl", 9204, "a linear cone edge", "cone_edge"},
          {"harness/glsl/lighting.glsl", 9205, "no least distance", "light_at_the_surface"},
          {"harness/glsl/lighting.glsl", 9206, "an unknown kind shines", "unknown_kind"},
          {"harness/glsl/lighting.glsl", 9207, "1 - cosine^2 for the cross product", "smoothest"},
          {"harness/glsl/lighting.glsl", 9208, "Smith's roots swapped", "every_roughness"},
          {"harness/glsl/lighting.glsl", 9209, "light from behind shines", "behind_the_surface"},
          {"harness/glsl/lighting.glsl", 9210, "Fresnel of the normal's angle", "every_roughness"},
          {"harness/glsl/lighting.glsl", 9211, "light that is no number is added", "no_numbers"}};
}

}  // namespace

Kernel describe() {
  return {
      .name = "deferred_lighting",
      .source = "Lazarek, Hammer 2025, deferred lighting; Walter et al. 2007, Heitz 2014, Schlick 1994; glTF's lights",
      .default_variant = "clustered",
      .params = layout_of<LightingParams>(),
      .ports = ports(),
      .variants = variants(),
      .oracle = expected_radiance,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = {radiance(kReason)},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::deferred_lighting
