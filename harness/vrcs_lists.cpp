#include "harness/vrcs_lists.h"

#include <algorithm>

#include "harness/groups.h"

namespace assay::vrcs {

namespace {

std::optional<Work> on_screen(Extent e, const Work& w) {
  if (w.x >= e.width || w.y >= e.height) return {};
  return w;
}

}  // namespace

std::optional<Work> work_of(const TileLists& lists, uint tile, uint lane, bool fog) {
  const uint across = tiles_of(lists.extent, kVrcsTileSide).width;
  const uint left = tile % across * 16, top = tile / across * 16;
  const uint word = lists.tiles[tile], count = word % 512;
  if (count == 0) return {};
  if (count > kVrcsTileEntries || (fog && word & kVrcsTileFog))
    return on_screen(lists.extent,
                     {.x = left + lane / 4 % 8 * 2 + lane % 2, .y = top + lane / 32 * 2 + lane / 2 % 2, .own = true});
  if (lane >= count) return {};
  if (word & kVrcsTile2x2) {  // no entries
    if (lane >= kVrcsTileCells) return {};
    const uint corner = lists.frame % 2;
    return on_screen(lists.extent,
                     {.x = left + lane % 8 * 2 + corner, .y = top + lane / 8 * 2 + corner, .copies = kCopyBits});
  }
  const uint entry = lists.entries[size_t{tile} * kVrcsTileEntries + lane];
  return on_screen(
      lists.extent,
      {.x = left + entry % 16, .y = top + entry / 16 % 16, .copies = entry / 256 % 8, .depth = entry / 2048});
}

ScreenList screen_list(const Case& c) {
  return {c.extent, c.input<uint>("list"), c.input<uint>("list_count")[0], c.input<DispatchArgs>("list_args")[0]};
}

uint entries_taken(const ScreenList& list) {
  const uint64_t threads = uint64_t{list.args.x} * list.args.y * list.args.z * kVrcsListGroup;
  return static_cast<uint>(std::min({uint64_t{list.count}, pixel_count(list.extent), threads}));
}

std::optional<Work> work_of(const ScreenList& list, uint i) {
  const uint entry = list.entries[i];
  if (entry >> 31) return {};
  return on_screen(list.extent, {.x = entry % 16384, .y = entry / 16384 % 16384, .copies = entry >> 28});
}

void set_screen_list(Case& c, const std::vector<Tile>& tiles, Pcg32& rng) {
  std::vector<size_t> order(tiles.size());
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    std::swap(order[i], order[rng.below(static_cast<uint32_t>(i + 1))]);
  }
  std::vector<uint> list;
  for (const size_t t : order)
    for (const Primary& p : tiles[t].primaries)
      list.push_back(p.x | p.y << kEntryCoordinateBits | p.copies << kEntryCopyShift);
  const Groups groups = spread_groups((list.size() + kVrcsListGroup - 1) / kVrcsListGroup);
  c.set_input("list_count", std::vector{static_cast<uint>(list.size())});
  c.set_input("list_args", std::vector{DispatchArgs{groups.x, groups.y, 1}});
  list.resize(pixels(c), kCopyBits << kEntryCopyShift);
  c.set_input("list", list);
}

Case changed(Case c, const std::string& input, const std::function<void(std::vector<uint>&)>& change) {
  std::vector<uint> words(c.input<uint>(input).begin(), c.input<uint>(input).end());
  change(words);
  c.set_input(input, words);
  return c;
}

}  // namespace assay::vrcs
