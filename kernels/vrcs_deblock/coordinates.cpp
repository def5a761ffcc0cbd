#include "kernels/vrcs_deblock/coordinates.h"

#include <algorithm>

namespace assay::vrcs_deblock {

namespace {

struct Pixel {
  uint x, y;
};
using Group = std::vector<Pixel>;  // pixels of a cell that share, in rows

struct Screen {
  Extent extent;
  std::span<const uvec2> visibility;
  std::span<const uint8_t> rates;
  uint frame;

  uvec2 seen(Pixel p) const {
    if (p.x >= extent.width || p.y >= extent.height) return {kVisibilityNone, kVisibilityNone};
    return visibility[size_t{p.y} * extent.width + p.x];
  }
};

// Bits 2 and up of a rate are its width, those below its height.
bool joined(uint rate, Pixel a, Pixel b) { return (rate / 4 != 0 || a.x == b.x) && (rate % 4 != 0 || a.y == b.y); }

// A cell's pixels by triangle, as far as its rate lets them share.
std::vector<Group> groups_of(const Screen& s, Pixel cell) {
  const uint rate = s.rates[size_t{cell.y} * ceil_div(s.extent.width, 2) + cell.x];
  std::vector<Group> groups;
  for (uint i = 0; i < 4; ++i) {
    const Pixel p{2 * cell.x + i % 2, 2 * cell.y + i / 2};
    if (s.seen(p).y == kVisibilityNone) continue;
    const auto with = std::ranges::find_if(
        groups, [&](const Group& g) { return joined(rate, g[0], p) && s.seen(g[0]) == s.seen(p); });
    if (with == groups.end())
      groups.push_back({p});
    else
      with->push_back(p);
  }
  return groups;
}

// Pairs side by side or one above the other alternate as a checkerboard, others first and last by frame.
Pixel primary_of(const Group& g, uint frame) {
  const bool in_line = g.size() == 2 && (g[0].x == g[1].x || g[0].y == g[1].y);
  const uint turn = in_line ? g[0].x + g[0].y + frame : frame;
  return turn % 2 == 0 ? g.front() : g.back();
}

uint entry_of(const Group& g, uint frame) {
  const Pixel primary = primary_of(g, frame);
  uint copies = 0;
  for (const Pixel& p : g) {
    if (p.x != primary.x && p.y == primary.y) copies |= kCopyHorizontal;
    if (p.x == primary.x && p.y != primary.y) copies |= kCopyVertical;
    if (p.x != primary.x && p.y != primary.y) copies |= kCopyDiagonal;
  }
  return primary.x % 16 | primary.y % 16 << kVrcsEntryYShift | copies << kVrcsEntryCopyShift;
}

void add_tile(const Screen& s, Pixel first_cell, Lists& to) {
  std::vector<uint> entries;
  size_t covered = 0, whole = 0;
  for (uint i = 0; i < 64; ++i) {
    const Pixel cell{first_cell.x + i % 8, first_cell.y + i / 8};
    if (2 * cell.x >= s.extent.width || 2 * cell.y >= s.extent.height) continue;
    const auto groups = groups_of(s, cell);
    for (const Group& g : groups) entries.push_back(entry_of(g, s.frame)), covered += g.size();
    whole += groups.size() == 1 && groups[0].size() == 4;
  }
  auto word = static_cast<uint>(entries.size());
  if (covered == 0) word |= kVrcsTileSky;
  if (covered != 0 && covered == entries.size()) word |= kVrcsTile1x1;
  if (whole == 64) word |= kVrcsTile2x2;
  if (entries.size() > kVrcsTileEntries || whole == 64) entries.clear();
  to.tiles.push_back(word);
  entries.resize(kVrcsTileEntries, 0xffffffffu);  // the rest may hold anything
  to.entries.insert(to.entries.end(), entries.begin(), entries.end());
}

}  // namespace

Lists lists_of(Extent e, std::span<const uvec2> visibility, std::span<const uint8_t> rates, uint frame) {
  const Screen s{e, visibility, rates, frame};
  const Extent tiles = tiles_of(e, kVrcsTileSide);
  Lists lists;
  for (uint y = 0; y < tiles.height; ++y)
    for (uint x = 0; x < tiles.width; ++x) add_tile(s, {8 * x, 8 * y}, lists);
  return lists;
}

}  // namespace assay::vrcs_deblock
