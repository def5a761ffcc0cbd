#include "kernels/pixel_commands/oracle.h"

#include <algorithm>
#include <array>

#include "harness/groups.h"
#include "harness/oracle.h"
#include "kernels/pixel_commands/groups.h"

namespace assay::pixel_commands {

uint32_t live_shaders(const Case& c) { return std::min(c.params<CommandParams>().shaders, 64u); }
uint32_t wave_size(const Case& c) { return 1u << std::clamp(c.params<CommandParams>().wave_log2, 3u, 7u); }
uint64_t tiles(const Case& c) { return tile_count(c.extent, 32); }

namespace {

constexpr uint64_t kMost = UINT32_MAX;

struct TileSums {  // of one shader in one tile
  std::span<const Group> groups = {};
  uint64_t pixels = 0, uniform_waves = 0, divergent_waves = 0;
  uint64_t waves() const { return uniform_waves + divergent_waves; }
};

struct Sorted {  // of the lists of a case
  const Case& input;
  CommandParams params;
  uint64_t wave, shaders, tiles;
  Grouped grouped;
  std::vector<TileSums> sums;  // shader * tiles + tile
  uint64_t unpadded = 0;       // entries that all pixels take, the shaders' last waves filled up
  uint64_t padding = 0;        // of all groups
  uint64_t capacity = 0;       // entries
};

uint64_t waves_of(const Sorted& l, uint64_t pixels) { return (pixels + l.wave - 1) / l.wave; }

std::vector<TileSums> sums_of(const Sorted& l) {
  std::vector<TileSums> sums(l.shaders * l.tiles);
  for (size_t tile = 0; tile < l.tiles; ++tile)
    for (size_t g = l.grouped.first_group[tile]; g < l.grouped.first_group[tile + 1]; ++g) {
      const Group& group = l.grouped.groups[g];
      TileSums& s = sums[group.shader * l.tiles + tile];
      s.groups = std::span(s.groups.empty() ? &group : s.groups.data(), s.groups.size() + 1);
      s.pixels += group.pixels;
      (group.divergent ? s.divergent_waves : s.uniform_waves) += waves_of(l, group.pixels);
    }
  return sums;
}

Sorted sorted_lists(const Case& c) {
  Sorted l = {c, c.params<CommandParams>(), wave_size(c), live_shaders(c), tiles(c), group_pixels(c), {}};
  l.sums = sums_of(l);
  l.unpadded = l.params.reserved + l.shaders * (l.wave - 1);
  l.capacity = uint64_t{l.params.waves} * l.wave;
  for (const TileSums& s : l.sums) {
    l.unpadded += s.pixels;
    l.padding += s.waves() * l.wave - s.pixels;
  }
  return l;
}

// What is laid out, in the order of the buffers.
struct Lists {
  std::vector<uint> entries = {}, commands = {};
  std::vector<Expected::Run> entry_runs = {}, command_runs = {};
  std::vector<WaveMaterial> wave_materials = {};
  std::vector<ShaderCommands> shaders = {};
  std::vector<TileCommands> tiles = {};
  std::vector<std::array<std::vector<uint>, 12>> rows = {};  // first waves, by shader and row
  std::vector<CommandRow> overflow = {};
  uint64_t waves = 0, overflow_pixels = 0, lost = 0;
};

void append_run(Lists& to, uint64_t first, uint64_t count) {
  if (count > 0) to.entry_runs.push_back({first, count});
}

// The largest commands first, so that the first waves of a tile are in the largest.
void append_commands(std::array<std::vector<uint>, 12>& rows, size_t kind, uint64_t wave, uint64_t waves) {
  for (size_t k = 6; k-- > 0;)
    for (const uint64_t size = uint64_t{1} << k; waves >= size; waves -= size, wave += size)
      rows[kind * 6 + k].push_back(static_cast<uint>(wave));
}

void append_padded(const Sorted& l, Lists& to, const TileSums& tile, size_t shader) {
  append_commands(to.rows[shader], 0, to.waves, tile.uniform_waves);
  append_commands(to.rows[shader], 1, to.waves + tile.uniform_waves, tile.divergent_waves);
  for (const Group& g : tile.groups) {
    const uint64_t waves = waves_of(l, g.pixels), padding = waves * l.wave - g.pixels;
    const auto from = l.grouped.entries.begin() + static_cast<std::ptrdiff_t>(g.first);
    to.entries.insert(to.entries.end(), from, from + static_cast<std::ptrdiff_t>(g.pixels));
    to.entries.insert(to.entries.end(), padding, 1u << 31);
    append_run(to, to.waves * l.wave, g.pixels);
    append_run(to, to.waves * l.wave + g.pixels, padding);
    to.wave_materials.insert(to.wave_materials.end(), waves, {g.material, static_cast<uint>(to.waves)});
    to.waves += waves;
  }
}

// Tiles in order while their padding leaves room for everything unpadded.
void lay_out_padded(const Sorted& l, Lists& to) {
  uint64_t padding = 0;
  for (size_t shader = 0; shader < l.shaders; ++shader) {
    uint64_t pixels = 0, waves = 0, padded_tiles = 0, padded_pixels = 0;
    const uint64_t first = to.waves;
    for (size_t t = 0; t < l.tiles; ++t) {
      const TileSums& tile = l.sums[shader * l.tiles + t];
      to.tiles.push_back({static_cast<uint>(tile.pixels),
                          static_cast<uint>(tile.uniform_waves + tile.divergent_waves * 65536),
                          static_cast<uint>(pixels), static_cast<uint>(waves)});
      pixels += tile.pixels;
      waves += tile.waves();
      padding += tile.waves() * l.wave - tile.pixels;
      if (l.unpadded + padding > l.capacity) continue;
      ++padded_tiles;
      padded_pixels = pixels;
      append_padded(l, to, tile, shader);
    }
    to.shaders.push_back({static_cast<uint>(first), static_cast<uint>(pixels), static_cast<uint>(padded_tiles), 0,
                          static_cast<uint>(pixels - padded_pixels)});
  }
}

// A tile's pixels are written whole or, for want of room, not at all; what room is left is filled up.
void append_overflow(const Sorted& l, Lists& to, size_t shader) {
  uint64_t at = to.shaders[shader].overflow_first * l.wave;
  const uint64_t end = at + waves_of(l, to.shaders[shader].overflow_pixels) * l.wave;
  uint64_t written = at;
  for (size_t t = to.shaders[shader].padded_tiles; t < l.tiles; ++t) {
    const TileSums& tile = l.sums[shader * l.tiles + t];
    at += tile.pixels;
    if (tile.pixels == 0) continue;
    if (at > l.capacity) {
      to.lost += tile.pixels;
      continue;
    }
    const auto from = l.grouped.entries.begin() + static_cast<std::ptrdiff_t>(tile.groups[0].first);
    to.entries.insert(to.entries.end(), from, from + static_cast<std::ptrdiff_t>(tile.pixels));
    append_run(to, written, tile.pixels);
    written = at;
  }
  const uint64_t filled = std::min(end, l.capacity);
  if (written >= filled) return;
  to.entries.insert(to.entries.end(), filled - written, 1u << 31);
  append_run(to, written, filled - written);
}

void lay_out_overflow(const Sorted& l, Lists& to) {
  uint64_t wave = to.waves;
  for (size_t s = 0; s < l.shaders; ++s) {
    const uint64_t waves = waves_of(l, to.shaders[s].overflow_pixels);
    const uint64_t room = l.params.waves - std::min<uint64_t>(wave, l.params.waves);
    to.shaders[s].overflow_first = static_cast<uint>(wave);
    to.overflow.push_back({static_cast<uint>(wave), static_cast<uint>(std::min(waves, room))});
    to.overflow_pixels += to.shaders[s].overflow_pixels;
    append_overflow(l, to, s);
    wave += waves;
  }
}

// Groups of the consumer: each runs several waves, of one command or of several small ones.
DispatchArgs args_of(const Sorted& l, uint64_t commands, uint64_t waves_a_command) {
  const uint64_t waves_a_group = uint64_t{1} << std::min(l.params.waves_per_group_log2, 5u);
  const uint64_t across = std::max<uint64_t>(1, waves_a_command / waves_a_group);
  const uint64_t groups = (commands * waves_a_command + across * waves_a_group - 1) / (across * waves_a_group);
  const Groups spread = spread_groups(groups);
  return {static_cast<uint>(across), spread.x, groups ? spread.y : 0};
}

void lay_out_rows(const Sorted& l, Lists& to, Answer& answer) {
  std::vector<CommandRow> rows;
  std::vector<DispatchArgs> args;
  for (size_t s = 0; s < l.shaders; ++s) {
    for (size_t r = 0; r < 12; ++r) {
      const auto& list = to.rows[s][r];
      rows.push_back({static_cast<uint>(to.commands.size()), static_cast<uint>(list.size())});
      args.push_back(args_of(l, list.size(), uint64_t{1} << r % 6));
      if (!list.empty()) to.command_runs.push_back({to.commands.size(), list.size()});
      to.commands.insert(to.commands.end(), list.begin(), list.end());
    }
    rows.push_back(to.overflow[s]);
    args.push_back(args_of(l, to.overflow[s].count, 1));
  }
  answer["command_rows"] = expect_all(rows);
  answer["args"] = expect_all(args);
}

// Uniform waves, then divergent ones, of each shader and tile; none of those in the overflow.
std::vector<DispatchArgs> tile_args_of(const Sorted& l, const Lists& lists) {
  const uint64_t waves_a_group = uint64_t{1} << std::min(l.params.waves_per_group_log2, 5u);
  std::vector<DispatchArgs> args;
  for (size_t s = 0; s < l.shaders; ++s)
    for (size_t t = 0; t < l.tiles; ++t) {
      const TileSums& tile = l.sums[s * l.tiles + t];
      for (const uint64_t waves : {tile.uniform_waves, tile.divergent_waves}) {
        const uint64_t padded = t < lists.shaders[s].padded_tiles ? waves : 0;
        args.push_back({static_cast<uint>((padded + waves_a_group - 1) / waves_a_group), 1, 1});
      }
    }
  return args;
}

// The baseline's answer: pixels by shader, tile and material, in scan order; then an invalid entry for each of the
// rest.
std::vector<uint> sorted_pixels(const Sorted& l) {
  std::vector<uint> sorted;
  for (const TileSums& tile : l.sums) {
    std::vector<Group> groups(tile.groups.begin(), tile.groups.end());
    std::ranges::sort(groups, {}, &Group::material);
    for (const Group& g : groups) {
      const auto from = l.grouped.entries.begin() + static_cast<std::ptrdiff_t>(g.first);
      sorted.insert(sorted.end(), from, from + static_cast<std::ptrdiff_t>(g.pixels));
    }
  }
  sorted.resize(pixels(l.input), 1u << 31);
  return sorted;
}

template <class T>
Expected in_runs(const std::vector<T>& elements, std::vector<Expected::Run> runs) {
  Expected expected = expect_all(elements);
  expected.live = std::move(runs);
  return expected;
}

uint saturated(uint64_t n) { return static_cast<uint>(std::min(n, kMost)); }

}  // namespace

Demand demand_of(const Case& c) {
  const Sorted l = sorted_lists(c);
  return {l.unpadded, l.unpadded + l.padding};
}

Answer list_pixels(const Case& c) {
  const Sorted l = sorted_lists(c);
  Lists lists;
  lists.rows.resize(l.shaders);
  lay_out_padded(l, lists);
  const std::vector<Expected::Run> waves = {{0, lists.waves}};
  lay_out_overflow(l, lists);
  Answer answer;
  lay_out_rows(l, lists, answer);
  uint64_t pixels = 0;
  for (const TileSums& s : l.sums) pixels += s.pixels;
  const CommandStatus status = {static_cast<uint>(pixels),
                                static_cast<uint>(lists.waves),
                                static_cast<uint>(lists.overflow_pixels),
                                static_cast<uint>(l.grouped.unlisted),
                                static_cast<uint>(lists.lost),
                                saturated(l.unpadded + l.padding)};
  answer["entries"] = in_runs(lists.entries, lists.entry_runs);
  answer["commands"] = in_runs(lists.commands, lists.command_runs);
  answer["wave_materials"] = in_runs(lists.wave_materials, waves);
  answer["shaders"] = expect_all(lists.shaders);
  answer["tiles"] = expect_all(lists.tiles);
  answer["tile_args"] = expect_all(tile_args_of(l, lists));
  answer["sorted"] = expect_all(sorted_pixels(l));
  answer["status"] = expect_all(std::vector{status});
  return answer;
}

}  // namespace assay::pixel_commands
