#include "kernels/vrcs_coordinates/oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/bounded.h"
#include "harness/groups.h"
#include "kernels/vrcs_coordinates/rules.h"

namespace assay::vrcs_coordinates {

uint64_t tiles(const Case& c) { return vrcs::tiles_in(c.extent); }
uint64_t entries(const Case& c) { return tiles(c) * kVrcsTileEntries; }
Extent cells(const Case& c) { return vrcs::cells_of(c.extent); }

namespace {

using vrcs::Coordinates;
using vrcs::Primary;
using vrcs::Tile;

// Calls of(primary) for those that are entries; returns where they stand.
template <class Of>
std::vector<Expected::Run> each_entry(const Coordinates& coordinates, const Of& of) {
  std::vector<Expected::Run> runs;
  for (size_t t = 0; t < coordinates.tiles.size(); ++t) {
    const Tile& tile = coordinates.tiles[t];
    if (!vrcs::is_stored(tile) || tile.primaries.empty()) continue;
    runs.push_back({t * kVrcsTileEntries, tile.primaries.size()});
    for (const Primary& p : tile.primaries) of(p);
  }
  return runs;
}

void add_answers(Answer& to, const Coordinates& coordinates, const std::string& rule) {
  std::vector<uint> words, entries;
  for (const Tile& tile : coordinates.tiles) words.push_back(tile.word);
  const auto runs = each_entry(coordinates, [&](const Primary& p) { entries.push_back(vrcs::entry_of(p)); });
  to["tiles" + rule] = expect_all(words);
  to["entries" + rule] = expect_all(entries);
  to["entries" + rule].live = runs;
  to["copy_bits" + rule] = expect_all(coordinates.copy_bits);
}

// View depth beyond the near plane, in codes, rounded to the nearest.
Interval depth_code(const VrcsParams& p, float depth) {
  if (vrcs::depth_of(depth) == 0) return exactly(kVrcsDepthCodes);
  const Interval view = exactly(p.near_plane) / exactly(depth) - exactly(p.near_plane);
  const Interval code = clamped(view * exactly(p.depth_scale) + exactly(0.5), 0, kVrcsDepthCodes);
  return {std::floor(code.low), std::floor(code.high)};
}

Expected depth_entries(const Case& c, const Coordinates& coordinates) {
  const auto p = c.params<VrcsParams>();
  const auto depth = c.input<float>("depth");
  std::vector<DepthEntry> low, high;
  const auto runs = each_entry(coordinates, [&](const Primary& primary) {
    const Interval code = depth_code(p, depth[size_t{primary.y} * c.extent.width + primary.x]);
    low.push_back({vrcs::entry_of(primary), static_cast<float>(code.low)});
    high.push_back({vrcs::entry_of(primary), static_cast<float>(code.high)});
  });
  Expected expected = expect_all(low);
  expected.high = expect_all(high).low;
  for (uint32_t i = 0; i <= low.size(); ++i) expected.first.push_back(i);
  expected.live = runs;
  return expected;
}

// Every primary, stored or not.
void add_list(Answer& to, const Coordinates& coordinates) {
  std::vector<uint> list;
  for (const Tile& tile : coordinates.tiles)
    for (const Primary& p : tile.primaries) list.push_back(p.x + p.y * 16384 + p.copies * (1u << 28));
  const Groups groups = spread_groups((list.size() + 63) / 64);
  to["list"] = expect_all(list);
  to["list"].live.emplace();
  if (!list.empty()) to["list"].live->push_back({0, list.size()});
  to["list_count"] = expect_all(std::vector{static_cast<uint>(list.size())});
  to["list_args"] = expect_all(std::vector{DispatchArgs{groups.x, list.empty() ? 0 : groups.y, 1}});
}

}  // namespace

Bytes unpack_depth_entries(std::span<const std::byte> from) {
  std::vector<DepthEntry> unpacked(from.size() / sizeof(uint));
  for (size_t i = 0; i < unpacked.size(); ++i) {
    uint entry;
    std::memcpy(&entry, from.data() + i * sizeof(uint), sizeof(uint));
    unpacked[i] = {entry % 2048, static_cast<float>(entry / 2048)};
  }
  return expect_all(unpacked).low;
}

Answer coordinates(const Case& c) {
  const auto p = c.params<VrcsParams>();
  const vrcs::View view{c.extent,
                        c.input<uvec2>("visibility"),
                        c.input<uint8_t>("rates"),
                        c.input<float>("depth"),
                        p.frame,
                        p.all_1x1 != 0,
                        p.fog_depth};
  Answer answer;
  const Coordinates strict = vrcs::coordinates_of(view);
  add_answers(answer, strict, "");
  answer["depth_entries"] = depth_entries(c, strict);
  add_list(answer, strict);
  add_answers(answer, vrcs::coordinates_of(view, same_surface(c)), " of same_surface");
  add_answers(answer, vrcs::coordinates_of(view, stored_normal(c)), " of stored_normal");
  add_answers(answer, vrcs::coordinates_of(view, rebuilt_normal(c)), " of rebuilt_normal");
  return answer;
}

}  // namespace assay::vrcs_coordinates
