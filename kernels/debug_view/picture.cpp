#include "kernels/debug_view/picture.h"

#include <algorithm>
#include <cmath>

#include "harness/clusters.h"
#include "harness/commands.h"
#include "harness/formats/cluster_lists.h"
#include "harness/groups.h"
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

WaveLists wave_lists(Extent extent, uint32_t shaders, std::span<const uvec2> pixels, Pcg32& rng) {
  WaveLists w;
  const auto room = static_cast<uint32_t>(command_waves(extent, shaders));
  w.entries.assign(size_t{room} * kWaveSize, kEntryInvalid);
  w.commands.assign(room, ~0u);
  uint32_t used_waves = 0, used_commands = 0;
  size_t next = 0;
  const auto fill_wave = [&](uint32_t wave) {  // now and then no more than a part of it
    const uint32_t most = rng.below(3) ? kWaveSize : 1 + rng.below(kWaveSize);
    for (uint32_t i = 0; i < most && next < pixels.size(); ++i, ++next)
      w.entries[size_t{wave} * kWaveSize + i] = pixels[next].y << kEntryCoordinateBits | pixels[next].x;
  };
  for (uint32_t row = 0; row < command_rows(shaders); ++row) {
    const bool overflow = row % kCommandRows == kOverflowRow;
    const uint32_t each = overflow ? 1 : 1u << row % kCommandRows % kCommandBuckets, wanted = rng.below(4);
    CommandRow list = {overflow ? used_waves : used_commands, 0};
    for (; list.count < wanted && next < pixels.size() && used_waves + each <= room; ++list.count) {
      if (!overflow) w.commands[used_commands++] = used_waves;
      for (uint32_t i = 0; i < each; ++i) fill_wave(used_waves++);
    }
    w.rows.push_back(list);
    const Groups groups = spread_groups(ceil_div(list.count * each, kWavesPerGroup));
    w.args.push_back({groups.x, groups.y, groups.z});
  }
  return w;
}

void add_cells(Picture& p, Pcg32& rng, uint32_t most) {
  p.grid = grid_over(p.extent, {12, 20}, 5);
  p.slice_edges = reversed_slice_edges(slice_edges(0.5, 60, p.grid.slices), 0.1f);
  for (uint32_t i = p.grid.columns * p.grid.rows * p.grid.slices; i > 0; --i) {
    const auto some = [&](uint32_t room) { return rng.below(3) ? rng.below(std::min(most, room) + 1) : 0; };
    p.cells.emplace_back(rng.next(), some(256) | some(256) << kClusterDecalShift | some(255) << kClusterProbeShift);
  }
  for (size_t i = 0; i < p.visibility.size(); ++i)
    p.depth.push_back(rng.below(4) ? static_cast<float>(0.1 / std::pow(10, rng.range(-1, 2.5)))
                                   : p.slice_edges[rng.below(p.grid.slices)]);
}

void add_vrcs(Picture& p, Pcg32& rng) {
  constexpr uint8_t kRates[] = {kRate1x1, kRate1x2, kRate2x1, kRate2x2};
  for (uint64_t i = tile_count(p.extent, kCellSide); i > 0; --i)
    p.rates.push_back(rng.below(9) ? kRates[rng.below(4)] : static_cast<uint8_t>(rng.next()));
  for (size_t i = 0; i < p.visibility.size(); ++i)
    p.copy_bits.push_back(static_cast<uint8_t>(rng.below(2) ? kCopyDuplicate : rng.below(8)));
  for (uint64_t i = tile_count(p.extent, kVrcsTileSide); i > 0; --i) {
    constexpr uint32_t kFlags[] = {0, 0, 0, kVrcsTileSky, kVrcsTile1x1, kVrcsTile2x2, kVrcsTileFog, ~kVrcsTileCount};
    p.vrcs_tiles.push_back(kFlags[rng.below(8)] | (rng.below(3) ? 223 + rng.below(4) : rng.below(512)));
  }
}

void add_shadows(Picture& p, Pcg32& rng, Extent atlas) {
  p.atlas = atlas;
  for (uint64_t i = pixel_count(atlas); i > 0; --i) switch (rng.below(8)) {
      case 0:
        p.shadow_depth.push_back(0);
        break;
      case 1:
        p.shadow_depth.push_back(1);
        break;
      case 2:
        p.shadow_depth.push_back(std::ldexp(1.0f, -static_cast<int>(rng.below(12))));
        break;
      default:
        p.shadow_depth.push_back(static_cast<float>(std::exp2(rng.range(-10, 0))));
    }
  constexpr uint32_t kCell = 32;  // a tile in each of these at most
  for (uint32_t y = 0; y + kCell <= atlas.height; y += kCell)
    for (uint32_t x = 0; x + kCell <= atlas.width; x += kCell)
      if (rng.below(4)) {
        const uint32_t side = 1 << rng.below(6);
        p.shadow_tiles.push_back({x + rng.below(kCell / side) * side, y + rng.below(kCell / side) * side, side});
      }
}

Case to_case(const Picture& p) {
  Case c = {.extent = p.extent};
  c.set_params(ViewParams{p.extent.width, p.extent.height, p.view, static_cast<uint32_t>(p.surface_materials.size()),
                          static_cast<uint32_t>(p.material_colours.size()), static_cast<uint32_t>(p.lists.size()),
                          static_cast<uint32_t>(p.shader_colours.size()), p.grid, p.atlas.width, p.atlas.height,
                          static_cast<uint32_t>(p.shadow_tiles.size())});
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
  c.set_input("surface_slots", p.slots);
  c.set_input("shader_colours", p.shader_colours);
  c.set_input("entries", p.waves.entries);
  c.set_input("commands", p.waves.commands);
  c.set_input("command_rows", p.waves.rows);
  c.set_input("command_args", p.waves.args);
  c.set_input("depth", p.depth.empty() ? std::vector<float>(pixel_count(p.extent)) : p.depth);
  c.set_input("cells", p.cells);
  c.set_input("rates", p.view != kViewRate ? std::vector<uint8_t>{0} : p.rates);
  c.set_input("copy_bits", p.view != kViewPrimary ? std::vector<uint8_t>{0} : p.copy_bits);
  c.set_input("vrcs_tiles", p.view != kViewPrimary ? std::vector<uint32_t>() : p.vrcs_tiles);
  c.set_input("vrcs_colours", vrcs_palette());
  std::vector<ShadowView> views(p.shadow_tiles.size());
  for (size_t i = 0; i < views.size(); ++i) views[i].tile = p.shadow_tiles[i];
  c.set_input("shadow_views", views);
  c.set_input("shadow_depth", p.shadow_depth.empty() ? std::vector<float>{0} : p.shadow_depth);
  c.set_input("slice_edges", p.slice_edges.empty() ? std::vector<float>{0} : p.slice_edges);
  return c;
}

}  // namespace assay::debug_view
