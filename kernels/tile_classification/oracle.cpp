#include "kernels/tile_classification/oracle.h"

#include <algorithm>
#include <array>

#include "harness/groups.h"
#include "harness/oracle.h"

namespace assay::tile_classification {

uint32_t live_workloads(const Case& c) { return std::min(c.params<ClassifyParams>().workloads, kMaxWorkloads); }
uint32_t live_passes(const Case& c) { return std::min(c.params<ClassifyParams>().passes, kMaxPasses); }
uint64_t tiles(const Case& c) { return tile_count(c.extent, kTileSide); }

namespace {

// A tile's mask holds every feature that touches the tile.
std::vector<uint> masks_of(const Case& c) {
  const auto features = c.input<uint>("features");
  const uint32_t across = tiles_of(c.extent, kTileSide).width;
  std::vector<uint> masks(tiles(c));
  size_t pixel = 0;
  for (uint32_t y = 0; y < c.extent.height; ++y)
    for (uint32_t x = 0; x < c.extent.width; ++x)
      masks[size_t{y / kTileSide} * across + x / kTileSide] |= features[pixel++];
  return masks;
}

// Of a pass's rows the first whose conditions the mask meets, or else the last.
size_t row_for(std::span<const Workload> table, const std::vector<size_t>& rows_of_pass, uint mask) {
  for (const size_t row : rows_of_pass) {
    const bool has_all = (~mask & table[row].required) == 0;
    const bool has_none = (mask & table[row].excluded) == 0;
    if (has_all && has_none) return row;
  }
  return rows_of_pass.back();
}

std::vector<size_t> rows_of(std::span<const Workload> table, uint pass) {
  std::vector<size_t> rows;
  for (size_t row = 0; row < table.size(); ++row)
    if (table[row].pass == pass) rows.push_back(row);
  return rows;
}

// The lists of all workloads. Each pass deals out the tiles that it wants; empty tiles, and those in which nothing
// concerns the pass, go to none.
std::vector<std::vector<uint>> lists_of(const Case& c, std::span<const Workload> table,
                                        const std::vector<uint>& masks) {
  const auto params = c.params<ClassifyParams>();
  std::vector<std::vector<uint>> lists(table.size());
  for (uint pass = 0; pass < live_passes(c); ++pass) {
    const auto rows = rows_of(table, pass);
    if (rows.empty()) continue;
    for (uint tile = 0; tile < masks.size(); ++tile)
      if (masks[tile] & params.relevant[pass]) lists[row_for(table, rows, masks[tile])].push_back(tile);
  }
  return lists;
}

// Planes of at most 65,535 tiles, equally filled.
DispatchArgs args_for(uint64_t listed, uint groups) {
  const Groups plane = spread_groups(listed);
  return {groups, plane.x, listed ? plane.y : 0};
}

uint saturated(uint64_t groups) { return static_cast<uint>(std::min<uint64_t>(groups, UINT32_MAX)); }

Expected runs_of(const std::vector<std::vector<uint>>& lists, uint64_t room) {
  std::vector<uint> entries;
  Expected expected;
  expected.live.emplace();
  for (size_t w = 0; w < lists.size(); ++w) {
    if (lists[w].empty()) continue;
    expected.live->push_back({w * room, lists[w].size()});
    entries.insert(entries.end(), lists[w].begin(), lists[w].end());
  }
  expected.low = expect_all(entries).low;
  return expected;
}

}  // namespace

Answer classify(const Case& c) {
  const auto params = c.params<ClassifyParams>();
  const auto table = c.input<Workload>("workloads").first(live_workloads(c));
  const uint64_t groups = std::min<uint64_t>(params.groups_per_tile, 65535);
  const auto masks = masks_of(c);
  const auto lists = lists_of(c, table, masks);

  std::vector<WorkloadCount> counts;
  std::vector<DispatchArgs> args;
  std::array<uint64_t, kMaxPasses> taken = {};
  for (size_t w = 0; w < lists.size(); ++w) {
    counts.push_back({static_cast<uint>(lists[w].size()), saturated(lists[w].size() * groups)});
    args.push_back(args_for(lists[w].size(), static_cast<uint>(groups)));
    if (table[w].pass < kMaxPasses) taken[table[w].pass] += lists[w].size();
  }
  std::vector<PassStatistics> statistics;
  for (uint pass = 0; pass < live_passes(c); ++pass)
    statistics.push_back({saturated(masks.size() * groups), saturated(taken[pass] * groups),
                          saturated((masks.size() - taken[pass]) * groups)});
  return {{"masks", expect_all(masks)},
          {"workload_tiles", runs_of(lists, masks.size())},
          {"workload_counts", expect_all(counts)},
          {"workload_args", expect_all(args)},
          {"statistics", expect_all(statistics)}};
}

}  // namespace assay::tile_classification
