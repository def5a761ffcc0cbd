#include "kernels/debug_view/picture.h"

#include <algorithm>

#include "kernels/debug_view/palette.h"

namespace assay::debug_view {

Picture empty_picture(Extent extent, uint32_t view, uint32_t surfaces, uint32_t materials) {
  Picture p = {.extent = extent, .view = view, .visibility = {pixel_count(extent), uvec2(kVisibilityNone)}};
  for (uint32_t i = 0; i < surfaces; ++i) p.surface_materials.push_back(i % materials);
  p.material_colours = material_palette(materials);
  p.masks.resize(p.tile_total());
  return p;
}

Picture busy_picture(Extent extent, uint32_t view) {
  Picture p = empty_picture(extent, view, 31, 7);
  for (uint32_t y = 0; y < extent.height; ++y)
    for (uint32_t x = 0; x < extent.width; ++x) p.at(x, y) = {x / 2 + 1000 * (y % 3), (x + 5 * y) % 31 | y % 4 << 30};
  for (uint32_t t = 0; t < p.tile_total(); ++t) p.masks[t] = 1u + t * 0x01000193u;
  return p;
}

List list_of(std::vector<uint32_t> tiles, uint32_t colour, uint32_t groups_per_tile) {
  const auto n = static_cast<uint32_t>(tiles.size());
  return {std::move(tiles), n, {groups_per_tile, n, n > 0}, colour};
}

Case to_case(const Picture& p) {
  Case c = {.extent = p.extent};
  c.set_params(ViewParams{p.extent.width, p.extent.height, p.view, static_cast<uint32_t>(p.surface_materials.size()),
                          static_cast<uint32_t>(p.material_colours.size()), static_cast<uint32_t>(p.lists.size())});
  std::vector<SurfaceRecord> surfaces(p.surface_materials.size());
  for (size_t i = 0; i < surfaces.size(); ++i) surfaces[i].material = p.surface_materials[i];
  std::vector<uint32_t> tiles, colours;
  std::vector<WorkloadCount> counts;
  std::vector<DispatchArgs> args;
  for (const List& list : p.lists) {
    std::vector<uint32_t> entries = list.tiles;
    entries.resize(p.tile_total(), ~0u);  // behind the list
    tiles.insert(tiles.end(), entries.begin(), entries.end());
    counts.push_back({list.counted, 0});
    args.push_back(list.args);
    colours.push_back(list.colour);
  }
  c.set_input("visibility", p.visibility);
  c.set_input("surfaces", surfaces);
  c.set_input("material_colours", p.material_colours);
  c.set_input("masks", p.masks);
  c.set_input("heat_colours", heat_palette());
  c.set_input("workload_tiles", tiles);
  c.set_input("workload_counts", counts);
  c.set_input("workload_args", args);
  c.set_input("workload_colours", colours);
  return c;
}

}  // namespace assay::debug_view
