#include "harness/kernel.h"

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
Groups per_shader(const Case& c) { return {live_shaders(c)}; }
Groups once(const Case&) { return {1}; }

// Pixels with copy bits have passes of their own: those of the other kind have no groups, and bind nothing.
bool has_copies(const Case& c) { return c.params<CommandParams>().copies != 0; }
Groups per_tile_plain(const Case& c) { return has_copies(c) ? Groups{0, 1, 1} : per_tile(c); }
Groups per_tile_copied(const Case& c) { return has_copies(c) ? per_tile(c) : Groups{0, 1, 1}; }
std::vector<Pass> a_tile(const std::string& shader) {
  return {Dispatch{shader + ".comp", per_tile_plain}, Dispatch{shader + "_copies.comp", per_tile_copied}};
}
std::vector<Pass> in_order(std::initializer_list<std::vector<Pass>> parts) {
  std::vector<Pass> passes;
  for (const auto& part : parts) passes.insert(passes.end(), part.begin(), part.end());
  return passes;
}

std::vector<Pass> offsets() { return {Dispatch{"scan.comp", per_shader}, Dispatch{"rows.comp", once}}; }

Extent copies_extent(const Case& c) { return has_copies(c) ? c.extent : Extent{1, 1}; }

Port copy_bits() {
  Port port = reads_image("copy_bits", Format::r8_uint, {"vrcs_coordinates.copy_bits"});
  port.extent = copies_extent;
  return port;
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * sizeof(uvec2) + surfaces(c) * sizeof(SurfaceSlot) + (has_copies(c) ? pixels(c) : 0),
          .bytes_written = entries(c) * sizeof(uint) + waves(c) * (sizeof(uint) + sizeof(WaveMaterial)) +
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
                reads<SurfaceSlot>("surface_slots", surfaces, {"scene.surface_slots"}), copy_bits(),
                writes<TileCommands>("tiles", tile_shaders), writes<ShaderCommands>("shaders", shaders),
                writes<CommandRow>("command_rows", rows), writes<DispatchArgs>("args", rows),
                writes<uint>("commands", waves), writes<WaveMaterial>("wave_materials", waves),
                writes<CommandStatus>("status", fixed(1)), writes<uint>("entries", entries)},
      .variants = {{.name = "tile_local",
                    .passes = in_order({a_tile("count"), offsets(), a_tile("scatter")}),
                    .constants = {{"THREADS", {64, 256}}},
                    .note = "a tile's surfaces in shared memory, counted twice"}},
      .oracle = list_pixels,
      .inputs = inputs(),
      .bounds = {exact("status", "integers only, saturated"), exact("tiles", "integers only"),
                 exact("shaders", "integers only"), exact("command_rows", "integers only"),
                 exact("args", "integers only"),
                 exact("wave_materials", "integers only; groups stand in a fixed order"),
                 same_set("commands", "a row's commands append in any order"),
                 same_set("entries", "a group's pixels stand in any order, its padding behind them")},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{640, 360}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
  };
}

}  // namespace assay::pixel_commands
