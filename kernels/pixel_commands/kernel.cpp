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

Extent copies_extent(const Case& c) { return c.params<CommandParams>().copies ? c.extent : Extent{1, 1}; }

Port copy_bits() {
  Port port = reads_image("copy_bits", Format::r8_uint);
  port.extent = copies_extent;
  return port;
}

Cost cost(const Case& c) {
  return {.bytes_read = pixels(c) * sizeof(uvec2) + surfaces(c) * sizeof(SurfaceSlot) + pixel_count(copies_extent(c)),
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
                    .passes = {Dispatch{"count.comp", per_tile}, Dispatch{"scan.comp", per_shader},
                               Dispatch{"rows.comp", once}, Dispatch{"scatter.comp", per_tile}},
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
