#include "harness/vrcs_oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/parallel.h"

namespace assay::vrcs {

float depth_of(float d) { return d > 0 && std::isnormal(d) ? d : 0.0f; }

bool is_stored(const Tile& t) { return t.primaries.size() <= kVrcsTileEntries && !(t.word & kVrcsTile2x2); }

uint entry_of(const Primary& p) { return p.x % 16 + p.y % 16 * 16 + p.copies * 256; }

namespace {

struct Pixel {
  uint x, y;
};
using Group = std::vector<Pixel>;  // pixels of one cell that share, in rows

// Whether the rate lets two pixels of a cell share. Rates that are none of the four let nobody.
bool rate_joins(uint rate, Pixel a, Pixel b) {
  switch (rate) {
    case kRate2x2:
      return true;
    case kRate2x1:
      return a.y == b.y;
    case kRate1x2:
      return a.x == b.x;
    default:
      return false;
  }
}

struct Screen {
  const View& view;
  const Sharing& sharing;

  size_t place(Pixel p) const { return size_t{p.y} * view.extent.width + p.x; }
  bool covered(Pixel p) const {
    return p.x < view.extent.width && p.y < view.extent.height &&
           view.visibility[place(p)] != uvec2(kVisibilityNone, kVisibilityNone);
  }
  bool share(Pixel a, Pixel b) const {
    return view.visibility[place(a)] == view.visibility[place(b)] || (sharing && sharing(place(a), place(b)));
  }
};

// A covered pixel joins the first group whose first pixel it may share with, or begins one.
std::vector<Group> groups_of(const Screen& s, Pixel cell) {
  const size_t at = size_t{cell.y} * cells_of(s.view.extent).width + cell.x;
  const uint rate = s.view.all_1x1 ? kRate1x1 : s.view.rates[at];
  std::vector<Group> groups;
  for (uint i = 0; i < 4; ++i) {
    const Pixel p{cell.x * 2 + i % 2, cell.y * 2 + i / 2};
    if (!s.covered(p)) continue;
    const auto joined =
        std::ranges::find_if(groups, [&](const Group& g) { return rate_joins(rate, g[0], p) && s.share(g[0], p); });
    if (joined == groups.end())
      groups.push_back({p});
    else
      joined->push_back(p);
  }
  return groups;
}

// Side by side or one below the other: that on a checkerboard which turns over each frame. Of three: there and back. Of
// four, and of two across: the first and the last in turn.
Pixel primary_of(const Group& g, uint frame) {
  constexpr size_t kThereAndBack[] = {0, 1, 2, 1};
  if (g.size() == 3) return g[kThereAndBack[frame % 4]];
  if (g.size() == 2 && (g[0].x == g[1].x || g[0].y == g[1].y)) return (g[0].x + g[0].y + frame) % 2 == 0 ? g[0] : g[1];
  return frame % 2 == 0 ? g.front() : g.back();
}

struct Counts {
  size_t covered = 0, whole_cells = 0;
  bool fogged = false;
};

void add_group(const Screen& s, const Group& g, Tile& tile, std::vector<uint8_t>& copy_bits) {
  const Pixel p = primary_of(g, s.view.frame);
  uint copies = 0;
  for (const Pixel& other : g) {
    if (s.place(other) == s.place(p)) continue;
    copies |= other.y == p.y ? kCopyHorizontal : other.x == p.x ? kCopyVertical : kCopyDiagonal;
    copy_bits[s.place(other)] = kCopyDuplicate;
  }
  copy_bits[s.place(p)] = static_cast<uint8_t>(copies);
  tile.primaries.push_back({p.x, p.y, copies});
}

uint word_of(const Tile& tile, const Counts& counts) {
  auto word = static_cast<uint>(tile.primaries.size());
  if (counts.covered == 0) word |= kVrcsTileSky;
  if (counts.covered != 0 && counts.covered == tile.primaries.size()) word |= kVrcsTile1x1;
  if (counts.whole_cells == 64) word |= kVrcsTile2x2;
  if (counts.fogged) word |= kVrcsTileFog;
  return word;
}

Tile tile_at(const Screen& s, Pixel first_cell, std::vector<uint8_t>& copy_bits) {
  Tile tile;
  Counts counts;
  for (uint i = 0; i < 64; ++i) {
    const Pixel cell{first_cell.x + i % 8, first_cell.y + i / 8};
    if (cell.x * 2 >= s.view.extent.width || cell.y * 2 >= s.view.extent.height) continue;
    auto groups = groups_of(s, cell);
    counts.whole_cells += groups.size() == 1 && groups[0].size() == 4;
    const size_t begin = tile.primaries.size();
    for (const Group& g : groups) {
      counts.covered += g.size();
      for (const Pixel& p : g)
        counts.fogged |= !s.view.depth.empty() && depth_of(s.view.depth[s.place(p)]) < depth_of(s.view.fog_depth);
      add_group(s, g, tile, copy_bits);
    }
    std::sort(tile.primaries.begin() + static_cast<std::ptrdiff_t>(begin), tile.primaries.end(),
              [](const Primary& a, const Primary& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  }
  tile.word = word_of(tile, counts);
  return tile;
}

}  // namespace

Coordinates coordinates_of(const View& view, const Sharing& sharing) {
  const Screen screen{view, sharing};
  const Extent tiles = tiles_of(view.extent, kVrcsTileSide);
  Coordinates c{std::vector<Tile>(pixel_count(tiles)), std::vector<uint8_t>(pixel_count(view.extent))};
  in_parallel(tiles.height, [&](uint64_t row) {
    for (uint x = 0; x < tiles.width; ++x)
      c.tiles[row * tiles.width + x] = tile_at(screen, {x * 8, static_cast<uint>(row) * 8}, c.copy_bits);
  });
  return c;
}

Lists lists_of(const Coordinates& coordinates) {
  Lists lists;
  for (const Tile& tile : coordinates.tiles) {
    lists.tiles.push_back(tile.word);
    if (is_stored(tile))
      for (const Primary& p : tile.primaries) lists.entries.push_back(entry_of(p));
    lists.entries.resize(lists.tiles.size() * kVrcsTileEntries, 0xffffffffu);
  }
  return lists;
}

}  // namespace assay::vrcs
