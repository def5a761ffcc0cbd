// The lists of a view: tiles that have decals, and the primaries of variable-rate shading.
#include <algorithm>
#include <cmath>

#include "harness/formats/visibility.h"
#include "harness/groups.h"
#include "harness/vrcs_lists.h"
#include "kernels/decal_atlas_sampling/inputs.h"

namespace assay::decal_atlas_sampling {

namespace {

bool takes_decals(float depth) { return depth >= kLeastDecalDepth && std::isfinite(depth); }

// In whose cell a decal is.
bool has_list(const Case& c, const DecalParams& p, uint32_t x, uint32_t y) {
  const float d = c.input<float>("depth")[size_t{y} * p.width + x];
  if (!takes_decals(d)) return false;
  const auto edges = c.input<float>("slice_edges");
  size_t slice = 0;
  while (slice + 1 < p.grid.slices && d <= edges[slice + 1]) ++slice;
  const size_t cell = (slice * p.grid.rows + y / p.grid.cell_height) * p.grid.columns + x / p.grid.cell_width;
  return (c.input<uvec2>("cells")[cell].y >> kClusterDecalShift & kClusterItemMask) != 0;
}

std::vector<uint32_t> tiles_with_decals(const Case& c) {
  const auto p = c.params<DecalParams>();
  std::vector<bool> has(tile_count(c.extent, kDecalTileSide));
  const uint32_t across = tiles_of(c.extent, kDecalTileSide).width;
  for (uint32_t y = 0; y < p.height; ++y)
    for (uint32_t x = 0; x < p.width; ++x)
      if (const size_t tile = size_t{y / kDecalTileSide} * across + x / kDecalTileSide; !has[tile])
        has[tile] = has_list(c, p, x, y);
  std::vector<uint32_t> tiles;
  for (uint32_t t = 0; t < has.size(); ++t)
    if (has[t]) tiles.push_back(t);
  return tiles;
}

}  // namespace

void set_decal_tiles(Case& c, const std::vector<uint32_t>& listed) {
  std::vector<uint32_t> all = listed;
  std::vector<bool> is_listed(tile_count(c.extent, kDecalTileSide));
  for (const uint32_t t : listed)
    if (t < is_listed.size()) is_listed[t] = true;
  for (uint32_t t = 0; t < is_listed.size(); ++t)
    if (!is_listed[t]) all.push_back(t);
  all.resize(is_listed.size());
  const Groups groups = spread_groups(listed.size());
  c.set_input("decal_tiles", all);
  c.set_input("decal_tile_count", std::vector{static_cast<uint>(listed.size())});
  c.set_input("decal_tile_args", std::vector{DispatchArgs{groups.x, listed.empty() ? 0 : groups.y, 1}});
}

void set_primaries(Case& c, const View& v) {
  const auto depth = c.input<float>("depth");
  std::vector<uvec2> visibility = v.visibility;
  for (size_t i = visibility.size(); i < depth.size(); ++i)
    visibility.emplace_back(i / v.extent.width / 24 * 1024 + i % v.extent.width / 24, 1);
  for (size_t i = 0; i < depth.size(); ++i)
    if (!takes_decals(depth[i])) visibility[i] = uvec2(kVisibilityNone);
  std::vector<uint8_t> rates = v.rates;
  rates.resize(pixel_count(vrcs::cells_of(v.extent)), kRate1x1);
  const auto coordinates = vrcs::coordinates_of(
      {.extent = v.extent, .visibility = visibility, .rates = rates, .depth = {}, .frame = v.params.frame});
  for (const char* channel : {"base_roughness", "normal"}) {
    const auto was = c.input<uint32_t>(channel);
    std::vector<uint32_t> now(was.begin(), was.end());
    for (const vrcs::Tile& tile : coordinates.tiles)
      for (const vrcs::Primary& p : tile.primaries)
        vrcs::for_each_store(v.extent, {.x = p.x, .y = p.y, .copies = p.copies}, [&](uint32_t x, uint32_t y) {
          now[size_t{y} * v.extent.width + x] = was[size_t{p.y} * v.extent.width + p.x];
        });
    c.set_input(channel, now);
  }
  vrcs::Lists lists = vrcs::lists_of(coordinates);
  std::ranges::replace(lists.entries, 0xffffffffu, 0x7eeu);  // a pixel of the tile that no list may be followed to
  c.set_input("vrcs_tiles", lists.tiles);
  c.set_input("vrcs_entries", lists.entries);
  set_decal_tiles(c, v.tiles ? *v.tiles : tiles_with_decals(c));
}

}  // namespace assay::decal_atlas_sampling
