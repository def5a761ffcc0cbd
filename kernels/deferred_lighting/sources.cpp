#include "kernels/deferred_lighting/sources.h"

#include <algorithm>

#include "harness/formats/visibility.h"
#include "harness/vrcs_lists.h"
#include "kernels/deferred_lighting/layout.h"

namespace assay::deferred_lighting {

void Sources::add(uint64_t pixel, uint32_t source) {
  if (first[pixel] == kNobody) {
    first[pixel] = source;
  } else if (first[pixel] != source) {
    std::vector<uint32_t>& more = others[pixel];
    if (std::ranges::find(more, source) == more.end()) more.push_back(source);
  }
}

namespace {

struct Screen {
  const Case& c;
  std::span<const uvec2> visibility = c.input<uvec2>("visibility");

  uint32_t place(uint32_t x, uint32_t y) const { return y * c.extent.width + x; }
  bool is_covered(uint64_t pixel) const { return visibility[pixel] != uvec2(kVisibilityNone, kVisibilityNone); }
};

// Where all of a tile is shaded, pixels that nothing covers are background.
void add_work(Sources& to, const Screen& s, const std::optional<vrcs::Work>& w) {
  if (!w || (w->own && !s.is_covered(s.place(w->x, w->y)))) return;
  vrcs::for_each_store(s.c.extent, *w, [&](uint32_t x, uint32_t y) { to.add(s.place(x, y), s.place(w->x, w->y)); });
}

// Of a tile without primaries all, of one whose word says that it is full none, of others what nothing covers.
void add_background(Sources& to, const Screen& s, uint32_t tile, uint32_t word) {
  const uint32_t count = word % 512;
  if (count == kVrcsTileCells && (word & kVrcsTile2x2) != 0) return;
  const uint32_t across = tiles_of(s.c.extent, kVrcsTileSide).width;
  for (uint32_t i = 0; i < kVrcsTilePixels; ++i) {
    const uint32_t x = tile % across * 16 + i % 16, y = tile / across * 16 + i / 16;
    if (x >= s.c.extent.width || y >= s.c.extent.height) continue;
    if (count == 0 || !s.is_covered(s.place(x, y))) to.add(s.place(x, y), kFromNowhere);
  }
}

}  // namespace

Sources sources_by_tiles(const Case& c) {
  const Screen s{c};
  const vrcs::TileLists lists = {c.extent, c.input<uint32_t>("tiles"), c.input<uint32_t>("tile_entries"),
                                 c.params<LightingParams>().frame};
  Sources sources(c);
  for (uint32_t t = 0; t < lists.tiles.size(); ++t) {
    add_background(sources, s, t, lists.tiles[t]);
    for (uint32_t lane = 0; lane < kVrcsTilePixels; ++lane) add_work(sources, s, vrcs::work_of(lists, t, lane));
  }
  return sources;
}

// The background is stored first: what the list has beside is stored over it.
Sources sources_by_list(const Case& c) {
  const Screen s{c};
  const vrcs::ScreenList list = vrcs::screen_list(c);
  Sources sources(c);
  for (uint32_t i = 0; i < vrcs::entries_taken(list); ++i) add_work(sources, s, vrcs::work_of(list, i));
  for (uint64_t pixel = 0; pixel < pixels(c); ++pixel)
    if (sources.first[pixel] == kNobody && !s.is_covered(pixel)) sources.first[pixel] = kFromNowhere;
  return sources;
}

}  // namespace assay::deferred_lighting
