#include "harness/scene/shadow_packing.h"

#include <algorithm>
#include <optional>

namespace assay::scene {
namespace {

uint64_t area_of(const std::vector<TileWish>& wishes) {
  uint64_t area = 0;
  for (const TileWish& w : wishes) area += uint64_t{w.views} * w.side * w.side;
  return area;
}

// Shrinks until the least atlas that could hold them is no larger than `most`, and gives back what room is then left.
// Squares of powers of two, the largest first, fill a power-of-two rectangle without a gap, so area and the largest
// side decide. Wishes come the most important first.
void make_fit(std::vector<TileWish>& wishes, uint32_t most, Packing& p) {
  const uint64_t room = uint64_t{most} * most;
  std::vector<uint32_t> asked;
  for (TileWish& w : wishes) asked.push_back(w.side = std::clamp(w.side, kLeastTile, most));
  while (area_of(wishes) > room) {
    size_t at = wishes.size();
    while (at > 0 && wishes[at - 1].side == kLeastTile) --at;
    if (at > 0) {
      wishes[at - 1].side /= 2;
    } else {
      ++p.dropped;
      wishes.pop_back();
    }
  }
  uint64_t area = area_of(wishes);
  for (size_t i = 0; i < wishes.size(); ++i) {
    TileWish& w = wishes[i];
    for (uint64_t more = 0; w.side < asked[i]; area += more, w.side *= 2) {
      more = uint64_t{3} * w.views * w.side * w.side;
      if (area + more > room) break;
    }
    p.halved += w.side < asked[i];
  }
}

// Which squares of kLeastTile are taken.
struct Occupied {
  uint32_t columns, rows;
  std::vector<bool> taken;

  Occupied(uint32_t width, uint32_t height)
      : columns(width / kLeastTile), rows(height / kLeastTile), taken(size_t{columns} * rows) {}
  bool is_free(const ShadowTile& t) const {
    const uint32_t side = t.side / kLeastTile, x = t.x / kLeastTile, y = t.y / kLeastTile;
    if (x + side > columns || y + side > rows) return false;
    for (uint32_t i = 0; i < side * side; ++i)
      if (taken[size_t{y + i / side} * columns + x + i % side]) return false;
    return true;
  }
  void take(const ShadowTile& t) {
    const uint32_t side = t.side / kLeastTile, x = t.x / kLeastTile, y = t.y / kLeastTile;
    for (uint32_t i = 0; i < side * side; ++i) taken[size_t{y + i / side} * columns + x + i % side] = true;
  }
  std::optional<ShadowTile> place(uint32_t side) const {
    for (uint32_t y = 0; y + side <= rows * kLeastTile; y += side)
      for (uint32_t x = 0; x + side <= columns * kLeastTile; x += side)
        if (const ShadowTile t = {x, y, side}; is_free(t)) return t;
    return {};
  }
};

// The wishes' tiles, those that `kept` holds in their places; nothing where one finds no room.
std::optional<Tiles> placed(std::vector<TileWish> wishes, uint32_t width, uint32_t height, const Tiles& kept) {
  Occupied occupied(width, height);
  Tiles tiles;
  for (const TileWish& w : wishes)
    for (uint32_t view = 0; view < w.views; ++view)
      if (const auto it = kept.find(tile_key(w.light, view)); it != kept.end() && it->second.side == w.side)
        occupied.take(it->second), tiles.insert(*it);
  std::ranges::stable_sort(wishes, std::greater(), &TileWish::side);
  for (const TileWish& w : wishes)
    for (uint32_t view = 0; view < w.views; ++view) {
      if (tiles.contains(tile_key(w.light, view))) continue;
      const auto tile = occupied.place(w.side);
      if (!tile) return {};
      occupied.take(*tile);
      tiles[tile_key(w.light, view)] = *tile;
    }
  return tiles;
}

}  // namespace

Packing pack_tiles(std::vector<TileWish> wishes, const Packing& before, uint32_t most) {
  std::ranges::sort(wishes, [](const TileWish& a, const TileWish& b) {
    return a.importance != b.importance ? a.importance > b.importance : a.light < b.light;
  });
  Packing p;
  make_fit(wishes, most, p);
  if (wishes.empty()) return p;
  uint32_t largest = kLeastTile;
  for (const TileWish& w : wishes) largest = std::max(largest, w.side);
  p.width = p.height = largest;
  for (const uint64_t area = area_of(wishes); uint64_t{p.width} * p.height < area;)
    (p.width == p.height ? p.width : p.height) *= 2;
  if (before.width >= p.width && before.height >= p.height && before.width <= most) {
    p.width = before.width, p.height = before.height;
    if (auto tiles = placed(wishes, p.width, p.height, before.tiles)) {
      p.tiles = std::move(*tiles);
      return p;
    }
  }
  p.tiles = *placed(wishes, p.width, p.height, {});
  return p;
}

}  // namespace assay::scene
