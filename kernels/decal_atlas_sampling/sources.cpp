#include "kernels/decal_atlas_sampling/sources.h"

#include <algorithm>

#include "harness/vrcs_lists.h"
#include "kernels/decal_atlas_sampling/layout.h"

namespace assay::decal_atlas_sampling {

namespace {

// No more than the list has room for, nor than groups are dispatched; tiles of the screen alone.
std::vector<uint32_t> tiles_taken(const Case& c) {
  const auto list = c.input<uint>("decal_tiles");
  const DispatchArgs args = c.input<DispatchArgs>("decal_tile_args")[0];
  const uint64_t groups = uint64_t{args.x} * args.y * args.z, count = c.input<uint>("decal_tile_count")[0];
  std::vector<uint32_t> tiles;
  for (size_t i = 0; i < std::min({uint64_t{list.size()}, groups, count}); ++i)
    if (list[i] < tile_count(c.extent, kDecalTileSide)) tiles.push_back(list[i]);
  return tiles;
}

}  // namespace

std::vector<uint32_t> sources_by_tiles(const Case& c) {
  const auto [width, height] = c.extent;
  const uint32_t across = tiles_of(c.extent, 16).width;
  std::vector<uint32_t> sources(pixels(c), kNobody);
  for (const uint32_t tile : tiles_taken(c)) {
    const uint32_t left = tile % across * 16, top = tile / across * 16;
    for (uint32_t y = top; y < std::min(top + 16, height); ++y)
      for (uint32_t x = left; x < std::min(left + 16, width); ++x) sources[size_t{y} * width + x] = y * width + x;
  }
  return sources;
}

std::vector<uint32_t> sources_by_primaries(const Case& c) {
  const uint32_t width = c.extent.width;
  const vrcs::TileLists lists = {c.extent, c.input<uint>("vrcs_tiles"), c.input<uint>("vrcs_entries"),
                                 c.params<DecalParams>().frame};
  std::vector<uint32_t> sources(pixels(c), kNobody);
  for (const uint32_t tile : tiles_taken(c))
    for (uint32_t lane = 0; lane < kVrcsTilePixels; ++lane)
      if (const auto work = vrcs::work_of(lists, tile, lane))
        vrcs::for_each_store(c.extent, *work, [&](uint32_t x, uint32_t y) {
          sources[size_t{y} * width + x] = work->y * width + work->x;
        });
  return sources;
}

}  // namespace assay::decal_atlas_sampling
