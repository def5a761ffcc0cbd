#include "kernels/deferred_texturing/lists.h"

#include <array>
#include <map>

#include "harness/formats/visibility.h"
#include "harness/formats/workloads.h"
#include "harness/groups.h"

namespace assay::deferred_texturing {

namespace {

struct Run {  // of one material in a tile
  std::vector<uint> entries;
  uint32_t surface = 0;
  bool is_uniform = true;
};
using Tile = std::map<uint32_t, Run>;  // by material

uint entry_of(const Listing& l, uint32_t x, uint32_t y) {
  const uint32_t copies = l.copy_bits.empty() ? 0 : l.copy_bits[size_t{y} * l.extent.width + x];
  return x | y << kEntryCoordinateBits | (copies & kCopyBits) << kEntryCopyShift;
}

// A slot's tiles, row by row.
std::vector<Tile> tiles_of_slot(const Listing& l, uint32_t slot) {
  const Extent tiles = tiles_of(l.extent, kTileSide);
  std::vector<Tile> found(uint64_t{tiles.width} * tiles.height);
  for (uint32_t y = 0; y < l.extent.height; ++y)
    for (uint32_t x = 0; x < l.extent.width; ++x) {
      const size_t pixel = size_t{y} * l.extent.width + x;
      const uint32_t surface = l.visibility[pixel].y & kVisibilitySurfaceMask;
      if (surface >= l.slots.size() || l.slots[surface].shader != slot) continue;
      if (!l.copy_bits.empty() && (l.copy_bits[pixel] & kCopyDuplicate) != 0) continue;
      Run& run = found[size_t{y / kTileSide} * tiles.width + x / kTileSide][l.slots[surface].material];
      if (run.entries.empty()) run.surface = surface;
      run.is_uniform &= run.surface == surface;
      run.entries.push_back(entry_of(l, x, y));
    }
  return found;
}

struct Writer {
  const Listing& l;
  Lists lists = {};

  // A run, padded to whole waves; stale entries come first where they fit. Their number of waves.
  uint32_t write_run(const Run& run) {
    const size_t waves = (run.entries.size() + kWaveSize - 1) / kWaveSize,
                 room = waves * kWaveSize - run.entries.size();
    const size_t before = lists.entries.size();
    if (room >= l.stale.size())
      for (const uint entry : l.stale)
        if (!run.is_uniform || shows_nothing(entry)) lists.entries.push_back(entry);
    lists.entries.insert(lists.entries.end(), run.entries.begin(), run.entries.end());
    lists.entries.resize(before + waves * kWaveSize, kEntryInvalid);
    return static_cast<uint32_t>(waves);
  }
  // A wave of one surface may hold such entries without ceasing to be one.
  bool shows_nothing(uint entry) const {
    const uint32_t mask = (1u << kEntryCoordinateBits) - 1, x = entry & mask, y = entry >> kEntryCoordinateBits & mask;
    return x >= l.extent.width || y >= l.extent.height ||
           (l.visibility[size_t{y} * l.extent.width + x].y & kVisibilitySurfaceMask) >= l.slots.size();
  }
  uint32_t wave() const { return static_cast<uint32_t>(lists.entries.size() / kWaveSize); }

  void write_kind(const std::vector<Tile>& tiles, bool uniform,
                  std::array<std::vector<uint>, kCommandBuckets>& commands) {
    for (uint32_t t = 0; t < std::min<size_t>(tiles.size(), l.tiles_with_room); ++t) {
      uint32_t first = wave(), waves = 0;
      for (const auto& [material, run] : tiles[t])
        if (run.is_uniform == uniform) waves += write_run(run);
      while (waves > 0) {
        uint32_t k = kCommandBuckets - 1;
        while (1u << k > waves) --k;
        commands[k].push_back(first);
        first += 1u << k, waves -= 1u << k;
      }
    }
  }
  void write_overflow(const std::vector<Tile>& tiles) {
    const uint32_t first = wave();
    Run all;
    for (size_t t = l.tiles_with_room; t < tiles.size(); ++t)
      for (const auto& [material, run] : tiles[t])
        all.entries.insert(all.entries.end(), run.entries.begin(), run.entries.end());
    add_row({first, write_run(all)}, 0);
  }
  void add_row(const CommandRow& row, uint32_t bucket) {
    const uint64_t waves = uint64_t{row.count} << bucket;
    const Groups g = spread_groups((waves + kWavesPerGroup - 1) / kWavesPerGroup);
    lists.rows.push_back(row);
    lists.args.push_back({g.x, g.y, g.z});
  }
  void write_slot(uint32_t slot) {
    const std::vector<Tile> tiles = tiles_of_slot(l, slot);
    for (const bool uniform : {true, false}) {
      std::array<std::vector<uint>, kCommandBuckets> commands;
      write_kind(tiles, uniform, commands);
      for (uint32_t k = 0; k < kCommandBuckets; ++k) {
        add_row({static_cast<uint32_t>(lists.commands.size()), static_cast<uint32_t>(commands[k].size())}, k);
        lists.commands.insert(lists.commands.end(), commands[k].begin(), commands[k].end());
      }
    }
    write_overflow(tiles);
  }
};

}  // namespace

Lists lists_of(const Listing& l) {
  Writer w = {l};
  for (uint32_t slot = 0; slot < l.shaders; ++slot) w.write_slot(slot);
  w.lists.waves = w.wave();
  w.lists.commands.resize(w.lists.waves, 0);
  return std::move(w.lists);
}

}  // namespace assay::deferred_texturing
