#include "harness/kernel.h"

#include "kernels/hi_z/inputs.h"
#include "kernels/hi_z/oracle.h"

namespace assay::hi_z {

namespace {

Groups none() { return {0, 1, 1}; }

// As many rows of groups as the level's number, which tells it to the shader.
Dispatch level_pass(uint32_t level) {
  return {"level.comp", [level](const Case& c) {
            if (level > level_count(c.extent)) return none();
            const auto groups = static_cast<uint32_t>((pixel_count(size_of_level(c.extent, level)) + 255) / 256);
            return Groups{ceil_div(groups, level), level, 1};
          }};
}
std::vector<Pass> level_passes() {
  std::vector<Pass> passes;
  for (uint32_t level = 1; level <= kMaxLevels; ++level) passes.emplace_back(level_pass(level));
  return passes;
}

// A group 32 x 32 texels of level `below`, which becomes five levels more; none where there is no level to make.
Dispatch tile_pass(const std::string& shader, uint32_t below) {
  return {shader, [below](const Case& c) {
            if (below >= level_count(c.extent)) return none();
            const Extent tiles = size_of_level(c.extent, below + 5);
            return Groups{tiles.width, tiles.height, 1};
          }};
}
std::vector<Pass> tile_passes(const std::string& by) {
  return {tile_pass("tiles_" + by + "_0.comp", 0), tile_pass("tiles_" + by + "_5.comp", 5),
          tile_pass("tiles_" + by + "_10.comp", 10)};
}

// Each pixel and texel once: what is read again of a level lies in the cache.
Cost cost(const Case& c) {
  return {
      .bytes_read = pixels(c) * sizeof(float), .bytes_written = texels(c) * sizeof(vec2), .operations = 2 * pixels(c)};
}

}  // namespace

Kernel describe() {
  Port groups_done = writes<uint>("groups_done", fixed(1));
  groups_done.only_in = {"last_group"};
  return {
      .name = "hi_z",
      .source = "Greene, Kass, Miller 1993, Hierarchical Z-Buffer Visibility; Coenen 2020, DOOM Eternal",
      .default_variant = "tiles_shared",
      .params = layout_of<HiZParams>(),
      .ports = {reads_image("depth", Format::d32_float, {"visibility.depth"}), writes<vec2>("ranges", texels),
                groups_done},
      .variants = {{.name = "level_by_level", .passes = level_passes(), .note = "a dispatch a level, a thread a texel"},
                   {.name = "tiles_shared",
                    .passes = tile_passes("shared"),
                    .note = "five levels a dispatch, in shared memory"},
                   {.name = "tiles_subgroup",
                    .passes = tile_passes("subgroup"),
                    .needs = {Feature::subgroup_shuffle},
                    .subgroup_min = 4,
                    .note = "the first of them by exchanging lanes"},
                   {.name = "last_group",
                    .passes = {Clear{"groups_done"}, tile_pass("last_group.comp", 0)},
                    .note = "one dispatch: the group that ends last makes the upper levels"}},
      .oracle = pyramid,
      .inputs = inputs(),
      .bounds = {exact("ranges", "the least and the greatest of floats are such floats")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = in_frame,
  };
}

}  // namespace assay::hi_z
