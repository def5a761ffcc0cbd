#include "harness/kernel.h"

#include "harness/clusters.h"
#include "kernels/decal_atlas_sampling/inputs.h"
#include "kernels/decal_atlas_sampling/oracle.h"

namespace assay::decal_atlas_sampling {

namespace {

Count counted(uint DecalParams::*member) {
  return [member](const Case& c) { return uint64_t{c.params<DecalParams>().*member}; };
}
uint64_t cells(const Case& c) {
  const ClusterGrid g = c.params<DecalParams>().grid;
  return uint64_t{g.columns} * g.rows * g.slices;
}
uint64_t edges(const Case& c) { return uint64_t{c.params<DecalParams>().grid.slices} + 1; }
uint64_t bit_words(const Case& c) { return (uint64_t{c.params<DecalParams>().decals} + 31) / 32 * cells(c); }
Groups per_pixel(const Case& c) {
  if (c.params<DecalParams>().decals == 0) return {0, 0, 0};
  return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1};
}

uint64_t tiles(const Case& c) { return tile_count(c.extent, kDecalTileSide); }
uint64_t vrcs_entries(const Case& c) { return tiles(c) * kVrcsTileEntries; }
uint64_t if_decals(const Case& c) { return c.params<DecalParams>().decals != 0; }

const std::vector<std::string> kOverTiles = {"tiles", "tiles_primaries"};
const std::vector<std::string> kByList = {
    "gradient",         "lod",   "scalarised",     "anisotropic_taps", "anisotropic_hardware",
    "block_compressed", "tiles", "tiles_primaries"};
const std::vector<std::string> kOfTexels = {
    "gradient", "lod",   "scalarised",     "anisotropic_taps", "anisotropic_hardware",
    "bitfield", "tiles", "tiles_primaries"};

Port only_in(std::vector<std::string> variants, Port p) {
  p.only_in = std::move(variants);
  return p;
}
// The G-buffer's channels as words: a code is kept to the bit where nothing touches it.
Port channel(const std::string& name, Format format) {
  return {.name = name,
          .use = Use::updates,
          .kind = PortKind::image,
          .format = format,
          .view = Format::r32_uint,
          .producers = {"deferred_texturing." + name}};
}

// Each port once: the lists as long as they are, every texel or block.
Cost cost_with(const std::string& atlas, const Case& c) {
  const auto p = c.params<DecalParams>();
  uint64_t texels = 0;
  for (const Texture& t : c.textures.at(atlas)) texels += t.bytes.size();
  return {.bytes_read = pixels(c) * (4 + 4 + 4 + 4) + edges(c) * sizeof(float) + p.decals * sizeof(DecalRecord) +
                        p.receivers * sizeof(ReceiverRecord) + cells(c) * sizeof(uvec2) + p.entries * sizeof(uint) +
                        texels,
          .bytes_written = pixels(c) * (4 + 4),
          .operations = pixels(c) * 40};  // position 20, cell 20; what decals cost is the scene's
}

Cost cost(const Case& c) { return cost_with("atlas", c); }
Cost cost_of_blocks(const Case& c) { return cost_with("atlas_blocks", c); }
Cost cost_of_tiles(const Case& c) {
  Cost of = cost(c);
  of.bytes_read += (tiles(c) + 1) * sizeof(uint) + sizeof(DispatchArgs);
  return of;
}
Cost cost_of_primaries(const Case& c) {
  Cost of = cost_of_tiles(c);
  of.bytes_read += (tiles(c) + vrcs_entries(c)) * sizeof(uint);
  return of;
}

Bound channel_bound(const std::string& port, Unpack unpack, const std::string& prefix, std::string reason) {
  Bound b = between({port}, std::move(reason));
  b.unpack = std::move(unpack), b.answer = prefix + port;
  return b;
}
std::vector<Bound> bounds(const std::string& prefix) {
  return {channel_bound("base_roughness", unpack_base_roughness(), prefix, "trilinear range, rounded to nearest"),
          channel_bound("normal", unpack_normal(), prefix, "trilinear range of the map, half an octahedral step")};
}

Variant variant(const std::string& name, const std::string& note, const std::string& answer = "") {
  return {.name = name, .passes = {Dispatch{name + ".comp", per_pixel}}, .bounds = bounds(answer), .note = note};
}
Variant over_tiles(const std::string& name, const std::string& note, const std::string& answer,
                   std::function<Cost(const Case&)> cost) {
  Variant v = variant(name, note, answer);
  v.passes = {Dispatch{.shader = name + ".comp", .indirect = "decal_tile_args", .repeat = if_decals}};
  v.cost = std::move(cost);
  return v;
}
std::vector<Variant> variants() {
  Variant scalarised = variant("scalarised", "a wave walks the union of its cells' lists, a decal at a time");
  scalarised.needs = {Feature::subgroup_arithmetic, Feature::subgroup_ballot};
  Variant blocks = variant("block_compressed", "as gradient; pages in BC7, BC5 and BC4", kBlocks);
  blocks.needs = {Feature::texture_compression_bc}, blocks.cost = cost_of_blocks;
  // What an anisotropic sampler takes in is free (Vulkan, Texel Anisotropic Filtering): a figure, without a bound.
  const Variant hardware = {.name = "anisotropic_hardware",
                            .passes = {Dispatch{"gradient.comp", per_pixel}},
                            .needs = {Feature::sampler_anisotropy},
                            .baseline = true,
                            .anisotropic = true,
                            .note = "as gradient; an anisotropic sampler"};
  return {variant("gradient", "gradients given to the sampler, isotropic and trilinear"),
          variant("lod", "the level worked out once for the three pages"),
          variant("anisotropic_taps", "four samples along the longer derivative", kTaps),
          std::move(scalarised),
          variant("bitfield", "the cell's decals as bits", kBits),
          std::move(blocks),
          over_tiles("tiles", "as gradient; on the tiles that have decals", kTiles, cost_of_tiles),
          over_tiles("tiles_primaries", "as tiles; primaries, whose copies get what they come out as", kPrimaries,
                     cost_of_primaries),
          hardware};
}

std::vector<Mutant> mutants() {
  return {{"common.glsl", 1, "every surface is square to the view", "grazing_levels"},
          {"sample.glsl", 4, "coordinates go up to the rectangle's sides", "loud_neighbours"},
          {"sample.glsl", 5, "half a texel of the first level at all levels", "loud_neighbours"},
          {"sample.glsl", 6, "only the way across is minified", "gradient_of_y"},
          {"sample.glsl", 7, "samples along the shorter derivative", "stripes_along"},
          {"blend.glsl", 8, "roughness is lost where the base colour is written alone", "base_alone"},
          {"blend.glsl", 9, "no decal fades", "fading"},
          {"blend.glsl", 10, "reoriented is whiteout", "reoriented"},
          {"blend.glsl", 11, "receivers turn, but do not move", "moving_receiver"},
          {"blend.glsl", 12, "the box has no depth", "behind_the_box"},
          {"blend.glsl", 13, "colours are mixed as they are stored", "half_covered"},
          {"lists.glsl", 14, "the last decal of a cell is forgotten", "one_decal"},
          {"walk.glsl", 15, "the last decal of a list comes first", "order"},
          {"scalarised.comp", 16, "all of the wave take each decal", "cells_apart"},
          {"bitfield.comp", 17, "the highest bit first", "order"},
          {"listed.glsl", 18, "groups left over work on what lies behind the list", "groups_left_over"},
          {"listed.glsl", 19, "tiles that there are not stand for others", "tile_number_wraps"},
          {"tiles.comp", 20, "tiles as far apart as those of 32 pixels", "one_tile_of_nine"},
          {"tiles_primaries.comp", 21, "normals are not stored", "all_2x2"},
          {"tiles_primaries.comp", 22, "the place in the list taken for the tile", "one_tile_of_nine"},
          {"tiles_primaries.comp", 23, "tiles that are shaded whole are left out", "primaries_225"},
          {"tiles_primaries.comp", 24, "nothing is copied", "all_2x2"},
          {"harness/glsl/vrcs.glsl", 9602, "the longest list is not taken", "primaries_224"},
          {"harness/glsl/vrcs.glsl", 9603, "one lane too many", "primaries_224"},
          {"harness/glsl/vrcs.glsl", 9604, "the upper left one in every frame", "all_2x2_odd_frame"},
          {"harness/glsl/vrcs.glsl", 9606, "the diagonal is forgotten", "all_2x2"},
          {"harness/glsl/clusters.glsl", 9401, "a depth on a boundary is in the slice before", "on_a_slice"},
          {"harness/glsl/clusters.glsl", 9402, "columns as wide as rows are high", "cells_apart"},
          {"harness/glsl/gbuffer.glsl", 9301, "normals of the lower half are not folded", "normal_turned_away"},
          {"harness/glsl/gbuffer.glsl", 9302, "nor unfolded", "normal_turned_away"},
          {"harness/glsl/gbuffer.glsl", 9305, "linear colour is stored", "half_covered"},
          {"harness/glsl/gbuffer.glsl", 9306, "the root of the base colour taken for it", "half_covered"}};
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(DecalParams{f.extent.width, f.extent.height, f.grid, f.decals.decals, list_capacity(f.grid),
                           f.decals.receivers, f.near_plane, static_cast<float>(f.decals.atlas_border), f.rays,
                           f.frame});
  return c;
}

}  // namespace

Kernel describe() {
  return {
      .name = "decal_atlas_sampling",
      .source = "Sousa, Geffroy 2016, Box Projected Decals; Pettineo 2016, Decals",
      .default_variant = "tiles",
      .params = layout_of<DecalParams>(),
      .ports = {reads_image("depth", Format::d32_float, {"visibility.depth"}),
                reads_image("depth_gradients", Format::rg16_float, {"depth_gradients.gradients"}),
                channel("base_roughness", Format::rgba8_unorm), channel("normal", Format::rg16_snorm),
                reads<float>("slice_edges", edges, {"scene.slice_edges"}),
                reads<DecalRecord>("decals", counted(&DecalParams::decals), {"scene.decals"}),
                reads<ReceiverRecord>("receivers", counted(&DecalParams::receivers), {"scene.receivers"}),
                only_in(kByList, reads<uvec2>("cells", cells, {"cluster_lists.cells"})),
                only_in(kByList, reads<uint>("entries", counted(&DecalParams::entries), {"cluster_lists.entries"})),
                only_in({"bitfield"}, reads<uint>("decal_bits", bit_words, {"cluster_voxelization.decal_bits"})),
                only_in(kOverTiles, reads<uint>("decal_tiles", tiles, {"decal_tiles.tiles"})),
                only_in(kOverTiles, reads<uint>("decal_tile_count", fixed(1), {"decal_tiles.count"})),
                only_in(kOverTiles, reads<DispatchArgs>("decal_tile_args", fixed(1), {"decal_tiles.args"})),
                only_in({"tiles_primaries"}, reads<uint>("vrcs_tiles", tiles, {"vrcs_coordinates.tiles"})),
                only_in({"tiles_primaries"}, reads<uint>("vrcs_entries", vrcs_entries, {"vrcs_coordinates.entries"})),
                only_in(kOfTexels, reads_textures("atlas", kAtlasTextures, {"scene.decal_atlas"})),
                only_in({"block_compressed"}, reads_textures("atlas_blocks", kAtlasTextures))},
      .variants = variants(),
      .oracle = decaled,
      .inputs = {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller},
      .bounds = bounds(""),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
      .undecided_limit = 2e-4,
      .undecided_reason = "pixels within rounding of a box's face: 1e-5 of the box where it is a tenth of its distance",
      .errors = error_table(),
  };
}

}  // namespace assay::decal_atlas_sampling
