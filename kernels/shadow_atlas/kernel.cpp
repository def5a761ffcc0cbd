#include "harness/kernel.h"

#include <algorithm>
#include <iterator>

#include "kernels/shadow_atlas/inputs.h"
#include "kernels/shadow_atlas/oracle.h"

namespace assay::shadow_atlas {

namespace {

ShadowCounts shadows_of(const Case& c) { return c.params<ShadowAtlasParams>().shadows; }

Count counted(uint SceneCounts::*member) {
  return [member](const Case& c) { return uint64_t{c.params<ShadowAtlasParams>().scene.*member}; };
}
Count counted(uint ShadowCounts::*member) {
  return [member](const Case& c) { return uint64_t{shadows_of(c).*member}; };
}

uint64_t draws(const Case& c) { return shadows_of(c).draw_first[kShadowDraws]; }

// Six vertices a tile.
DrawCall still_quads(const char* fragment) {
  return {.vertex = "still_quads.vert", .fragment = fragment, .count = [](const Case& c) {
            return uint64_t{6} * shadows_of(c).still_tiles;
          }};
}
// Of an atlas without tiles to draw, one that is nowhere: a frame that has the atlas has this kernel.
DrawCall moving_quads(const char* fragment) {
  return {.vertex = "moving_quads.vert", .fragment = fragment, .count = [](const Case& c) {
            const ShadowCounts n = shadows_of(c);
            return n.width == 0 ? 0 : uint64_t{6} * std::max(n.tiles, 1u);
          }};
}
Draw quads(const char* port, std::vector<DrawCall> calls) {
  return {.depth = DepthTarget{.port = port, .compare = Compare::always}, .calls = std::move(calls)};
}

DrawCall casters(const char* vertex, const char* fragment, uint32_t range) {
  const auto edge = [range](const Case& c, uint32_t i) { return uint64_t{shadows_of(c).draw_first[range + i]}; };
  return {.vertex = vertex,
          .fragment = fragment,
          .first = [edge](const Case& c) { return edge(c, 0); },
          .count = [edge](const Case& c) { return edge(c, 1) - edge(c, 0); }};
}
std::vector<DrawCall> still_casters() {
  return {casters("still.vert", "opaque.frag", kShadowStill),
          casters("still_masked.vert", "masked.frag", kShadowStillMasked)};
}
std::vector<DrawCall> moving_casters() {
  return {casters("moving.vert", "opaque.frag", kShadowMoving),
          casters("moving_masked.vert", "masked.frag", kShadowMovingMasked)};
}
std::vector<DrawCall> all_casters() {
  std::vector<DrawCall> all = still_casters();
  std::ranges::move(moving_casters(), std::back_inserter(all));
  return all;
}
Draw drawn(const char* port, std::vector<DrawCall> calls) {
  return {.depth = DepthTarget{.port = port, .compare = Compare::greater},
          .indices = "indices",
          .commands = "draws",
          .calls = std::move(calls)};
}

// Each vertex, index and record once, each texel of `images` images read and written.
Cost cost(const Case& c, uint64_t images) {
  const auto [scene, shadows] = c.params<ShadowAtlasParams>();
  uint64_t cut = 0;  // what only masked draws read
  if (shadows.draw_first[kShadowStillMasked] < shadows.draw_first[kShadowMoving] ||
      shadows.draw_first[kShadowMovingMasked] < shadows.draw_first[kShadowDraws]) {
    cut = uint64_t{scene.vertices} * sizeof(VertexAttributes) + scene.materials * sizeof(MaterialRecord);
    if (const auto t = c.textures.find("textures"); t != c.textures.end())
      for (const Texture& texture : t->second) cut += texture.bytes.size();
  }
  const uint64_t tiles = uint64_t{shadows.still_tiles} + shadows.tiles;
  uint64_t vertices = 0;  // that are placed: four dot products of four
  for (const DrawCommand& d : c.input<DrawCommand>("draws")) vertices += uint64_t{d.index_count} * d.instance_count;
  return {.bytes_read = uint64_t{scene.indices} * 4 + uint64_t{scene.vertices} * sizeof(vec3) +
                        shadows.casters * sizeof(ShadowCaster) + draws(c) * sizeof(DrawCommand) +
                        tiles * sizeof(ShadowTile) + cut + images * pixels(c) * sizeof(float),
          .bytes_written = images * pixels(c) * sizeof(float),
          .operations = vertices * 28};
}

const char* const kDepths =
    "coverage by the top-left rule within the sub-pixel grid, depth within plane rounding, alpha within the filter's, "
    "of all that was drawn the greatest (README, Bounds)";

}  // namespace

Kernel describe() {
  Port still = updates_image("still", Format::d32_float);
  still.only_in = {"cached"};
  Bound redrawn = between({"depth"}, kDepths);
  redrawn.answer = "redrawn";
  return {
      .name = "shadow_atlas",
      .source = "Sousa, Geffroy 2016, The Devil is in the Details; Coenen 2020, DOOM Eternal",
      .default_variant = "cached",
      .params = layout_of<ShadowAtlasParams>(),
      .ports = {reads<vec3>("positions", counted(&SceneCounts::vertices), {"scene.positions"}),
                reads<VertexAttributes>("attributes", counted(&SceneCounts::vertices), {"scene.attributes"}),
                reads<uint>("indices", counted(&SceneCounts::indices), {"scene.indices"}),
                reads<MaterialRecord>("materials", counted(&SceneCounts::materials), {"scene.materials"}),
                reads_textures("textures", 16, {"scene.textures"}),
                reads<ShadowCaster>("casters", counted(&ShadowCounts::casters), {"scene.shadow_casters"}),
                reads<DrawCommand>("draws", draws, {"scene.shadow_draws"}),
                reads<ShadowTile>("still_tiles", counted(&ShadowCounts::still_tiles), {"scene.shadow_still_tiles"}),
                reads<ShadowTile>("tiles", counted(&ShadowCounts::tiles), {"scene.shadow_tiles"}), still,
                updates_image("depth", Format::d32_float)},
      .variants = {{.name = "cached",
                    .passes = {quads("still", {still_quads("clear.frag")}), drawn("still", still_casters()),
                               quads("depth", {moving_quads("copy.frag")}), drawn("depth", moving_casters())},
                    .needs = {Feature::clip_distance},
                    .note = "still depths are kept, moving things drawn over a copy"},
                   {.name = "redraw",
                    .passes = {quads("depth", {still_quads("clear.frag"), moving_quads("clear.frag")}),
                               drawn("depth", all_casters())},
                    .needs = {Feature::clip_distance},
                    .bounds = std::vector{redrawn},
                    .cost = [](const Case& c) { return cost(c, 1); },
                    .note = "all of a tile is drawn anew"}},
      .oracle = shadows,
      .inputs = inputs(),
      .bounds = {between({"still"}, kDepths), between({"depth"}, kDepths)},
      .mutants = mutants(),
      .cost = [](const Case& c) { return cost(c, 2); },
      .typical = typical,
      .extents = {{1024, 1024}, {4096, 4096}},
      .frame = frame,
      .undecided_limit = 5e-3,
      .undecided_reason = "texels within 1/256 of an edge and alpha at its cutoff",
  };
}

}  // namespace assay::shadow_atlas
