#include <algorithm>

#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/layout.h"
#include "kernels/deferred_lighting/oracle.h"

namespace assay::deferred_lighting {
namespace {

Groups per_tile(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
uint64_t lights(const Case& c) { return c.params<LightingParams>().lights; }
uint64_t cells(const Case& c) {
  const ClusterGrid g = c.params<LightingParams>().grid;
  return uint64_t{g.columns} * g.rows * g.slices;
}
uint64_t entries(const Case& c) { return c.params<LightingParams>().entries; }
uint64_t slice_edges(const Case& c) { return uint64_t{c.params<LightingParams>().grid.slices} + 1; }

// Operations of a light at a pixel: 150 in common, as the shader counts them; of as many lights as a cell lists.
Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * (4 + 4 + 4 + 2 + 4 + 4) + lights(c) * sizeof(LightRecord) +
                        cells(c) * sizeof(uvec2) + entries(c) * sizeof(uint) + slice_edges(c) * sizeof(float),
          .bytes_written = pixels(c) * 8,
          .operations = pixels(c) * (60 + 150 * entries(c) / std::max<uint64_t>(cells(c), 1))};
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
  for (Port& p : std::vector<Port>{reads<uvec2>("cells", cells, {"cluster_lists.cells"}),
                                   reads<uint>("entries", entries, {"cluster_lists.entries"}),
                                   reads<float>("slice_edges", slice_edges, {"scene.slice_edges"})}) {
    p.only_in = {"clustered", "clustered_scalarised"};
    all.push_back(std::move(p));
  }
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

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "the last column is not on the screen", "odd_extent"},
          {"common.glsl", 2, "a pixel's corner for its centre", "one_pixel"},
          {"common.glsl", 3, "depth taken for distance", "light_at_the_surface"},
          {"common.glsl", 4, "ambient light without occlusion", "no_light"},
          {"common.glsl", 5, "neither held above 0 nor below infinity", "negative_light"},
          {"common.glsl", 6, "the background is left as it was", "background"},
          {"plain.comp", 7, "the last light is left out", "one_pixel"},
          {"tiled_shared.comp", 8, "the first barrier dropped", "one_light_over_two_batches"},
          {"tiled_shared.comp", 9, "a whole batch though fewer lights are left", "one_light_over_two_batches"},
          {"tiled_shared.comp", 10, "the second barrier dropped", "many_lights"},
          {"subgroup_cull.comp", 11, "lights are left out at half their range", "range_edge"},
          {"subgroup_cull.comp", 12, "the first lane's box for the wave's", "light_in_one_pixel"},
          {"subgroup_cull.comp", 13, "every light taken for the first of its round", "many_lights"},
          {"lists.glsl", 14, "the last light is not there", "cells_of_one_light"},
          {"clustered.comp", 15, "a list's first light is left out", "cells_of_one_light"},
          {"clustered_scalarised.comp", 16, "the first lane's light for the least of all", "cells_within_a_wave"},
          {"clustered_scalarised.comp", 17, "a wave of two cells taken for one of the first", "cells_within_a_wave"},
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
      .variants = {{.name = "plain",
                    .passes = {Dispatch{"plain.comp", per_tile}},
                    .note = "each pixel walks all lights"},
                   {.name = "tiled_shared",
                    .passes = {Dispatch{"tiled_shared.comp", per_tile}},
                    .note = "a group fetches lights once, through shared memory"},
                   {.name = "subgroup_cull",
                    .passes = {Dispatch{"subgroup_cull.comp", per_tile}},
                    .needs = {Feature::subgroup_ballot, Feature::subgroup_arithmetic},
                    .note = "a wave leaves out lights whose range its pixels' box is beyond"},
                   clustered("clustered", {}, "each pixel walks the lights of its cell"),
                   clustered("clustered_scalarised", {Feature::subgroup_ballot, Feature::subgroup_arithmetic},
                             "a wave walks the lights of its cells together, in one cell without asking")},
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
