#include "kernels/decal_tiles/oracle.h"

#include <algorithm>
#include <cmath>

#include "harness/groups.h"
#include "harness/oracle.h"

namespace assay::decal_tiles {

uint64_t tiles(const Case& c) { return tile_count(c.extent, kDecalTileSide); }

namespace {

struct View {
  DecalTileParams params;
  Extent extent;
  std::span<const float> edges;
  std::span<const uvec2> cells;

  explicit View(const Case& c)
      : params(c.params<DecalTileParams>()),
        extent(c.extent),
        edges(c.input<float>("slice_edges")),
        cells(c.input<uvec2>("cells")) {}
  // The last slice that begins at this reversed depth or nearer.
  uint32_t slice(float depth) const {
    uint32_t found = 0;
    for (uint32_t k = 1; k < params.grid.slices; ++k)
      if (depth <= edges[k]) found = k;
    return found;
  }
  uint32_t column(uint32_t x) const { return std::min(x / params.grid.cell_width, params.grid.columns - 1); }
  uint32_t row(uint32_t y) const { return std::min(y / params.grid.cell_height, params.grid.rows - 1); }
  bool lists_decal(uint32_t column, uint32_t row, uint32_t slice) const {
    const ClusterGrid& g = params.grid;
    return (cells[(size_t{slice} * g.rows + row) * g.columns + column].y >> 12) % 4096 != 0;
  }
};

struct Box {  // of pixels, `right` and `bottom` among them
  uint32_t left, top, right, bottom;
};
Box pixels_of(Extent e, uint64_t tile) {
  const auto across = tiles_of(e, 16).width;
  const auto left = static_cast<uint32_t>(tile % across * 16), top = static_cast<uint32_t>(tile / across * 16);
  return {left, top, std::min(left + 15, e.width - 1), std::min(top + 15, e.height - 1)};
}

bool has_decal_between(const View& v, const Box& b, float nearest, float farthest) {
  for (uint32_t slice = v.slice(nearest); slice <= v.slice(farthest); ++slice)
    for (uint32_t row = v.row(b.top); row <= v.row(b.bottom); ++row)
      for (uint32_t column = v.column(b.left); column <= v.column(b.right); ++column)
        if (v.lists_decal(column, row, slice)) return true;
  return false;
}

std::vector<bool> tiles_by_range(const Case& c) {
  const View v(c);
  const auto ranges = c.input<vec2>("ranges").subspan(v.params.first_range);
  std::vector<bool> has(tiles(c));
  for (size_t t = 0; t < has.size(); ++t)
    has[t] = ranges[t].y >= kLeastDecalDepth && has_decal_between(v, pixels_of(c.extent, t), ranges[t].y, ranges[t].x);
  return has;
}

void add_answers(Answer& to, const std::vector<bool>& has, const std::string& variant) {
  std::vector<uint> list;
  for (uint t = 0; t < has.size(); ++t)
    if (has[t]) list.push_back(t);
  const Groups groups = spread_groups(list.size());
  Expected& expected = to["tiles of " + variant] = expect_all(list);
  expected.live.emplace();
  if (!list.empty()) expected.live->push_back({0, list.size()});
  to["count of " + variant] = expect_all(std::vector{static_cast<uint>(list.size())});
  to["args of " + variant] = expect_all(std::vector{DispatchArgs{groups.x, list.empty() ? 0 : groups.y, 1}});
}

}  // namespace

std::vector<bool> tiles_by_pixel(const Case& c) {
  const View v(c);
  const auto depth = c.input<float>("depth");
  std::vector<bool> has(tiles(c));
  for (size_t t = 0; t < has.size(); ++t) {
    const Box b = pixels_of(c.extent, t);
    for (uint32_t y = b.top; y <= b.bottom && !has[t]; ++y)
      for (uint32_t x = b.left; x <= b.right && !has[t]; ++x) {
        const float d = depth[size_t{y} * c.extent.width + x];
        has[t] = d >= kLeastDecalDepth && std::isfinite(d) && v.lists_decal(v.column(x), v.row(y), v.slice(d));
      }
  }
  return has;
}

Answer listed_tiles(const Case& c) {
  Answer answer;
  add_answers(answer, tiles_by_range(c), "hi_z");
  add_answers(answer, tiles_by_pixel(c), "per_pixel");
  return answer;
}

}  // namespace assay::decal_tiles
