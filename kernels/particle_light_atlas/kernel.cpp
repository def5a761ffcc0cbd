#include "harness/kernel.h"

#include <algorithm>

#include "kernels/particle_light_atlas/inputs.h"
#include "kernels/particle_light_atlas/oracle.h"

namespace assay::particle_light_atlas {

namespace {

ParticleLightParams params(const Case& c) { return c.params<ParticleLightParams>(); }
uint64_t particles(const Case& c) { return params(c).particles; }
uint64_t blocks(const Case& c) { return params(c).blocks; }
uint64_t lights(const Case& c) { return params(c).lights; }
uint64_t cells(const Case& c) {
  const ClusterGrid g = params(c).grid;
  return uint64_t{g.columns} * g.rows * g.slices;
}
uint64_t entries(const Case& c) { return params(c).entries; }
uint64_t slice_edges(const Case& c) { return uint64_t{params(c).grid.slices} + 1; }
uint64_t shadow_views(const Case& c) { return params(c).shadow_views; }
Extent shadow_extent(const Case& c) { return {params(c).shadow_width, params(c).shadow_height}; }
Extent atlas_extent(const Case& c) { return {params(c).side, params(c).side}; }
Extent direction_extent(const Case& c) { return {params(c).side / 2, params(c).side / 2}; }

// Bytes of the ports, and 150 operations of a light at a texel, with its shadow 220 more.
uint64_t lit_texels(const Case& c) {
  const uint64_t listed = std::min<uint64_t>(c.input<ParticleRectCounts>("counts")[0].blocks, blocks(c));
  return listed * kLightBlockSide * kLightBlockSide;
}
Cost cost_of(const Case& c, uint64_t lights_a_texel, uint64_t bytes_of_texel) {
  return {.bytes_read = particles(c) * (sizeof(ParticleRecord) + sizeof(uint)) + blocks(c) * sizeof(uint) +
                        sizeof(ParticleRectCounts) + sizeof(DispatchArgs) + lights(c) * sizeof(LightRecord),
          .bytes_written = pixel_count(atlas_extent(c)) * bytes_of_texel + pixel_count(direction_extent(c)) * 4,
          .operations = lit_texels(c) * (60 + 150 * lights_a_texel)};
}
Cost with_lists(const Case& c, uint64_t bytes_of_texel) {
  Cost all = cost_of(c, entries(c) / std::max<uint64_t>(cells(c), 1), bytes_of_texel);
  all.bytes_read += cells(c) * sizeof(uvec2) + entries(c) * sizeof(uint) + slice_edges(c) * sizeof(float);
  return all;
}
Cost cost_by_list(const Case& c) { return with_lists(c, 4); }
Cost cost_of_rgba16(const Case& c) { return with_lists(c, 8); }
Cost cost_of_all(const Case& c) { return cost_of(c, lights(c), 4); }
std::function<Cost(const Case&)> in_shadow(std::function<Cost(const Case&)> unshadowed) {
  return [unshadowed = std::move(unshadowed)](const Case& c) {
    Cost all = unshadowed(c);
    all.bytes_read += shadow_views(c) * sizeof(ShadowView) + pixel_count(shadow_extent(c)) * sizeof(float);
    all.operations += all.operations * 220 / 150;
    return all;
  };
}

const std::vector<std::string> kListed = {"r11g11b10f", "rgb9e5", "rgba16f", "scalarised", "r11g11b10f_shadowed"};
const std::vector<std::string> kShadowed = {"r11g11b10f_shadowed", "all_lights_shadowed"};

Port in(const std::vector<std::string>& variants, Port p, std::function<Extent(const Case&)> extent = {}) {
  p.only_in = variants;
  p.extent = std::move(extent);
  return p;
}

const char* const kAtlases[] = {"atlas", "atlas_rgb9e5", "atlas_rgba16"};  // by kLight...
// Readers sample it as the encoding's format; words are stored.
Port atlas(uint32_t code, Format format, Format words) {
  Port p = writes_image(kAtlases[code], format);
  p.view = words;
  return p;
}

std::vector<Port> ports() {
  return {reads<ParticleRecord>("particles", particles, {"scene.particles"}),
          reads<uint>("rects", particles, {"particle_rects.rects"}),
          reads<uint>("blocks", blocks, {"particle_rects.blocks"}),
          reads<ParticleRectCounts>("counts", fixed(1), {"particle_rects.counts"}),
          reads<DispatchArgs>("args", fixed(1), {"particle_rects.args"}),
          reads<LightRecord>("lights", lights, {"scene.lights"}),
          in({"r11g11b10f", "scalarised", "all_lights", "r11g11b10f_shadowed", "all_lights_shadowed"},
             atlas(kLightR11G11B10, Format::r11g11b10_float, Format::r32_uint), atlas_extent),
          in({"rgb9e5"}, atlas(kLightRgb9e5, Format::rgb9e5_float, Format::r32_uint), atlas_extent),
          in({"rgba16f"}, atlas(kLightRgba16, Format::rgba16_float, Format::rg32_uint), atlas_extent),
          in({}, writes_image("direction", Format::rg16_snorm), direction_extent),
          in(kListed, reads<uvec2>("cells", cells, {"cluster_lists.cells"})),
          in(kListed, reads<uint>("entries", entries, {"cluster_lists.entries"})),
          in(kListed, reads<float>("slice_edges", slice_edges, {"scene.slice_edges"})),
          in(kShadowed, reads<ShadowView>("shadow_views", shadow_views, {"scene.shadow_views"})),
          in(kShadowed, reads_image("shadow_depth", Format::d32_float, {"shadow_atlas.depth"}), shadow_extent)};
}

std::vector<Bound> bounds(const std::string& walk, const std::string& encoding, uint32_t code) {
  Bound atlas = between({kAtlases[code]},
                        "running error of fp32 by Vulkan's table (README, Bounds), then the nearest code of each end");
  atlas.unpack = Unpack{texel_layout(), unpack_texels(code)};
  atlas.answer = walk + " atlas " + encoding;
  Bound direction = between({"direction"}, "running error of the sum, then an octahedral step");
  direction.unpack = Unpack{direction_layout(), unpack_directions};
  direction.answer = walk + " direction";
  return {atlas, direction};
}

Variant variant(const std::string& name, const std::string& walk, const std::string& encoding, uint32_t code,
                std::function<Cost(const Case&)> cost, const std::string& note) {
  return {.name = name,
          .passes = {Dispatch{.shader = name + ".comp", .indirect = "args"}},
          .bounds = bounds(walk, encoding, code),
          .cost = std::move(cost),
          .note = note};
}

std::vector<Variant> variants() {
  const auto r11 = [](const std::string& name, const std::string& walk, std::function<Cost(const Case&)> cost,
                      const std::string& note) {
    return variant(name, walk, "r11g11b10f", kLightR11G11B10, std::move(cost), note);
  };
  Variant scalarised = r11("scalarised", "listed", cost_by_list, "a wave walks the lists of its cells together");
  scalarised.needs = {Feature::subgroup_ballot, Feature::subgroup_arithmetic};
  return {
      r11("r11g11b10f", "listed", cost_by_list, "a thread a texel walks the list of its cell"),
      variant("rgb9e5", "listed", "rgb9e5", kLightRgb9e5, cost_by_list, "the same; one exponent for three"),
      variant("rgba16f", "listed", "rgba16f", kLightRgba16, cost_of_rgba16, "the same; halves, twice the bytes"),
      scalarised,
      r11("all_lights", "all", cost_of_all, "a thread a texel walks all lights"),
      r11("r11g11b10f_shadowed", "listed_shadowed", in_shadow(cost_by_list), "as r11g11b10f; 3x3 taps of each shadow"),
      r11("all_lights_shadowed", "all_shadowed", in_shadow(cost_of_all), "as all_lights; 3x3 taps of each shadow")};
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "the last block is left out", "one_particle"},
          {"common.glsl", 2, "blocks that the rectangle does not have", "garbage_words"},
          {"harness/glsl/particle_surface.glsl", 9841, "the normals of small quads are short", "tiny_particle"},
          {"harness/glsl/particle_surface.glsl", 9842, "normals whichever way the axes go round", "many_blocks"},
          {"common.glsl", 5, "a texel's corner for its centre", "one_particle"},
          {"common.glsl", 6, "no ambient light", "no_light"},
          {"common.glsl", 7, "for the direction all lights count the same", "two_lights"},
          {"common.glsl", 8, "the direction of one of four texels", "light_close_by"},
          {"cells.glsl", 9, "all in the first slice", "cells_of_one_light"},
          {"all_lights.glsl", 10, "the last light is left out", "one_particle"},
          {"harness/glsl/light_lists_own.glsl", 9831, "a list's first light is left out", "one_particle"},
          {"harness/glsl/light_lists_scalarised.glsl", 9832, "the first lane's light for the least of all",
           "cells_of_one_light"},
          {"harness/glsl/light_lists_scalarised.glsl", 9833, "a wave of two cells taken for one of the first",
           "cells_of_one_light"},
          {"harness/glsl/gbuffer.glsl", 9301, "the lower half of directions is not folded", "light_behind"}};
}

}  // namespace

Kernel describe() {
  return {
      .name = "particle_light_atlas",
      .source = "Sousa, Geffroy 2016, Decoupled Particle Lighting; Coenen 2020, DOOM Eternal",
      .default_variant = "r11g11b10f",
      .params = layout_of<ParticleLightParams>(),
      .ports = ports(),
      .variants = variants(),
      .oracle = expected_light,
      .inputs = inputs(),
      .mutants = mutants(),
      .cost = cost_by_list,
      .typical = typical,
      .extents = {{256, 256}, {512, 512}, {1024, 1024}},
      .frame = in_frame,
  };
}

}  // namespace assay::particle_light_atlas
