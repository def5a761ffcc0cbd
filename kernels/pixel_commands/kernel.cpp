#include "harness/kernel.h"

#include <algorithm>

#include "harness/groups.h"
#include "kernels/pixel_commands/inputs.h"
#include "kernels/pixel_commands/oracle.h"

namespace assay::pixel_commands {

namespace {

uint64_t surfaces(const Case& c) { return c.params<CommandParams>().surfaces; }
uint64_t waves(const Case& c) { return c.params<CommandParams>().waves; }
uint64_t entries(const Case& c) { return waves(c) * wave_size(c); }
uint64_t shaders(const Case& c) { return live_shaders(c); }
uint64_t tile_shaders(const Case& c) { return tiles(c) * live_shaders(c); }
uint64_t rows(const Case& c) { return shaders(c) * kCommandRows; }

Groups per_tile(const Case& c) { return spread_groups(tiles(c)); }
Groups per_pixel(const Case& c) { return spread_groups((pixels(c) + 255) / 256); }
Groups per_shader(const Case& c) { return {live_shaders(c)}; }
Groups per_list(const Case& c) { return {live_shaders(c) * kOverflowRow}; }
Groups once(const Case&) { return {1}; }

// Pixels with copy bits have passes of their own: those of the other kind have no groups, and bind nothing.
bool has_copies(const Case& c) { return c.params<CommandParams>().copies != 0; }
std::vector<Pass> by_copies(const std::string& shader, Groups (*groups)(const Case&)) {
  return {Dispatch{shader + ".comp",
                   [groups](const Case& c) {
                     return has_copies(c) ? Groups{0, 1, 1} : groups(c);
                   }},
          Dispatch{shader + "_copies.comp", [groups](const Case& c) {
                     return has_copies(c) ? groups(c) : Groups{0, 1, 1};
                   }}};
}
std::vector<Pass> in_order(std::initializer_list<std::vector<Pass>> parts) {
  std::vector<Pass> passes;
  for (const auto& part : parts) passes.insert(passes.end(), part.begin(), part.end());
  return passes;
}

Extent copies_extent(const Case& c) { return has_copies(c) ? c.extent : Extent{1, 1}; }

// Keys of listed pixels are below it.
uint64_t key_range(const Case& c) {
  return live_shaders(c) * tiles(c) * std::min(c.params<CommandParams>().materials, kMaxMaterials);
}

// Ports that the list-making variants share, and those that only some have.
Port listed(Port port) {
  port.only_in = {"global_atomics", "tile_local", "subgroup", "single_pass", "stable", "dispatch_per_tile"};
  return port;
}
Port in_sort(const char* name, Count n) {
  Port port = writes<uint>(name, std::move(n));
  port.only_in = {"sort"};
  return port;
}
// Two words, the rows, then two words a shader and tile (chain.glsl).
Port chain() {
  Port port = writes<uint>(
      "chain", [](const Case& c) { return 2 + uint64_t{live_shaders(c)} * kOverflowRow + 2 * tile_shaders(c); });
  port.only_in = {"single_pass"};
  return port;
}
Port tile_args() {
  Port port = writes<DispatchArgs>("tile_args", [](const Case& c) { return 2 * tile_shaders(c); });
  port.only_in = {"dispatch_per_tile"};
  return port;
}
// A tile's pixels in the order of the lists, and where its groups begin (tile_list.glsl): from the count to the
// scatter.
Port tile_lists() {
  return listed(writes<uint>("tile_lists", [](const Case& c) { return tiles(c) * kTilePixels; }));
}
Port tile_groups() {
  return listed(writes<uint>("tile_groups", [](const Case& c) { return tiles(c) * kTileWords; }));
}
// All but a dispatch a tile have lists of commands.
Port command_list() {
  Port port = listed(writes<uint>("commands", waves));
  std::erase(port.only_in, "dispatch_per_tile");
  return port;
}
Port table(const char* name) {
  Port port = writes<uint>(name, [](const Case& c) { return tiles(c) * kTilePixels; });
  port.only_in = {"global_atomics"};
  return port;
}

// The sort takes four bits a pass, there and back, as many as the keys have: unlisted pixels' are all ones.
uint64_t sort_blocks(const Case& c) { return (pixels(c) + 4095) / 4096; }
uint64_t sort_counters(const Case& c) { return 16 * (sort_blocks(c) + 1); }
std::vector<Pass> sorting() {
  std::vector<Pass> passes = by_copies("sort_keys", per_pixel);
  for (uint32_t shift = 0; shift < 32; shift += 4) {
    const auto only = [shift](Count groups) {
      return [shift, groups = std::move(groups)](const Case& c) {
        const uint32_t low = shift / 8 * 8;  // the first of a pair of passes
        return key_range(c) >> low > 0 ? spread_groups(groups(c)) : Groups{0, 1, 1};
      };
    };
    const std::string way = shift % 8 == 0 ? "there" : "back";
    passes.insert(passes.end(), {Dispatch{"sort_count_" + way + ".comp", only(sort_blocks)},
                                 Dispatch{"sort_scan.comp", only(fixed(16))},
                                 Dispatch{"sort_scatter_" + way + ".comp", only(sort_blocks)}});
  }
  return passes;
}

Port copy_bits() {
  Port port = reads_image("copy_bits", Format::r8_uint, {"vrcs_coordinates.copy_bits"});
  port.extent = copies_extent;
  return port;
}

std::vector<Bound> tile_bounds() {
  return {exact("status", "integers only, saturated"),
          exact("tiles", "integers only"),
          exact("shaders", "integers only"),
          exact("tile_args", "integers only"),
          exact("args", "integers only"),
          exact("wave_materials", "integers only; groups stand in a fixed order"),
          same_set("entries", "a group's pixels stand in any order, its padding behind them")};
}

std::vector<Bound> bounds(bool ordered) {
  const auto list = ordered ? exact : same_set;
  return {exact("status", "integers only, saturated"),
          exact("tiles", "integers only"),
          exact("shaders", "integers only"),
          exact("command_rows", "integers only"),
          exact("args", "integers only"),
          exact("wave_materials", "integers only; groups stand in a fixed order"),
          list("commands", ordered ? "a row's commands in the order of tiles" : "a row's commands append in any order"),
          list("entries", ordered ? "a group's pixels in scan order"
                                  : "a group's pixels stand in any order, its padding behind them")};
}

std::vector<Variant> variants() {
  const Dispatch scan = {"scan.comp", per_shader}, rows = {"rows.comp", once}, scatter = {"scatter.comp", per_tile};
  return {{.name = "global_atomics",
           .passes = in_order({{Clear{"table_surfaces", UINT32_MAX}, Clear{"table_pixels"}},
                               by_copies("global_count", per_pixel),
                               {Dispatch{"global_sum.comp", per_tile}},
                               by_copies("global_list", per_pixel),
                               {scan, rows, scatter}}),
           .constants = {{"THREADS", {64}}},
           .note = "a tile\'s surfaces in global memory, two atomics a pixel"},
          {.name = "tile_local",
           .passes = in_order({by_copies("count", per_tile), {scan, rows, scatter}}),
           .constants = {{"THREADS", {32, 256}}, {"ABREAST", {1, 8}}},
           .note = "in shared memory, an atomic a run of a thread's pixels"},
          {.name = "subgroup",
           .passes = in_order({by_copies("count_lanes", per_tile), {scan, rows, scatter}}),
           .constants = {{"THREADS", {256, 64}}, {"ABREAST", {8, 32}}},
           .needs = {Feature::subgroup_ballot},
           .note = "in shared memory, an atomic a subgroup and surface"},
          {.name = "single_pass",
           .passes = in_order({{Clear{"chain"}},
                               by_copies("count_chained", per_tile),
                               {Dispatch{"scan_chained.comp", per_shader}, rows, scatter}}),
           .constants = {{"THREADS", {64, 256}}, {"PATIENCE", {4096, 1}}, {"ABREAST", {32}}},
           .needs = {Feature::forward_progress},
           .note = "the count adds up the tiles before it as they are counted; a scan where that takes too long"},
          {.name = "stable",
           .passes = in_order(
               {by_copies("count_stable", per_tile),
                {scan, rows, Dispatch{"commands_stable.comp", per_list}, Dispatch{"scatter_stable.comp", per_tile}}}),
           .constants = {{"THREADS", {256}}},
           .bounds = bounds(true),
           .note = "pixels in scan order, commands in the order of tiles: the same bits every time"},
          {.name = "dispatch_per_tile",
           .passes = in_order({by_copies("count", per_tile), {scan, rows, Dispatch{"scatter_tiles.comp", per_tile}}}),
           .constants = {{"THREADS", {32, 64}}},
           .bounds = tile_bounds(),
           .note = "a dispatch a shader, tile and kind in place of lists of commands"},
          {.name = "sort",
           .passes = sorting(),
           .bounds = {{exact("sorted", "integers only, a stable sort")}},
           .note = "baseline: a radix sort by shader, tile and material, without padding, counts or commands"}};
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * sizeof(uvec2) + surfaces(c) * sizeof(SurfaceSlot) + (has_copies(c) ? pixels(c) : 0),
          .bytes_written = entries(c) * sizeof(uint) + waves(c) * (sizeof(uint) + sizeof(WaveMaterial)) +
                           tiles(c) * (kTilePixels + kTileWords) * sizeof(uint) +
                           tile_shaders(c) * sizeof(TileCommands) + shaders(c) * sizeof(ShaderCommands) +
                           rows(c) * (sizeof(CommandRow) + sizeof(DispatchArgs)) + sizeof(CommandStatus),
          .operations = pixels(c) * 4};  // mask, compare with the neighbour, pack, add the place
}

}  // namespace

Kernel describe() {
  return {
      .name = "pixel_commands",
      .source = "Lazarek, Hammer 2025, Material Compute Dispatch",
      .default_variant = "tile_local",
      .params = layout_of<CommandParams>(),
      .ports = {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads<SurfaceSlot>("surface_slots", surfaces, {"scene.surface_slots"}),
                copy_bits(),
                listed(writes<TileCommands>("tiles", tile_shaders)),
                listed(writes<ShaderCommands>("shaders", shaders)),
                listed(writes<CommandRow>("command_rows", rows)),
                listed(writes<DispatchArgs>("args", rows)),
                command_list(),
                listed(writes<WaveMaterial>("wave_materials", waves)),
                listed(writes<CommandStatus>("status", fixed(1))),
                listed(writes<uint>("entries", entries)),
                chain(),
                tile_args(),
                tile_lists(),
                tile_groups(),
                table("table_surfaces"),
                table("table_pixels"),
                in_sort("sort_keys", pixels),
                in_sort("sorted", pixels),
                in_sort("other_keys", pixels),
                in_sort("other_sorted", pixels),
                in_sort("digit_counts", sort_counters),
                in_sort("sort_shift", fixed(2))},
      .variants = variants(),
      .oracle = list_pixels,
      .inputs = inputs(),
      .bounds = bounds(false),
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
  };
}

}  // namespace assay::pixel_commands
