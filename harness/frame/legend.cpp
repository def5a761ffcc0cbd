#include "harness/frame/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>

#include "harness/formats/cluster_lists.h"
#include "harness/formats/debug_view.h"
#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/workloads.h"

namespace assay::frame {

namespace {

constexpr size_t kMostRows = 36;  // of one legend; the rest is counted

constexpr std::pair<uint32_t, const char*> kFeatureNames[] = {
    {kFeatureOpaque, "opaque"},
    {kFeatureMasked, "masked"},
    {kFeatureDoubleSided, "2-sided"},
    {kFeatureCloth, "cloth"},
    {kFeatureSkin, "skin"},
    {kFeatureDecals, "decals"},
    {kFeatureWetnessDrops, "drops"},
    {kFeaturePuddles, "puddles"},
    {kFeatureCaustics, "caustics"},
    {kFeatureSubsurface, "subsurface"},
    {kFeatureReflective, "reflective"},
    {kFeatureEmissive, "emissive"},
    {kFeatureTextured, "textured"},
};

constexpr const char* kShaderNames[kShaderClasses] = {"opaque", "masked", "two layers", "emissive detail",
                                                      "cloth",  "skin",   "wet",        "foliage"};

struct Row {
  uint32_t colour;
  std::string text;
  uint64_t count;
};

struct Looking {
  const Result& result;
  const scene::Scene& scene;
  const scene::Gathered& gathered;
  const Case& palette;

  std::vector<uvec2> visibility() const { return words<uvec2>("visibility.visibility"); }
  template <class T>
  std::vector<T> words(const std::string& name) const {
    const auto it = result.downloads.find(name);
    if (it == result.downloads.end()) return {};
    std::vector<T> values(it->second.size() / sizeof(T));
    std::memcpy(values.data(), it->second.data(), values.size() * sizeof(T));
    return values;
  }
  uint32_t image_at(uint32_t x, uint32_t y) const {
    const uint8_t* texel = &result.image.texels[(size_t{y} * result.size.width + x) * 4];
    return texel[0] | static_cast<uint32_t>(texel[1]) << 8 | static_cast<uint32_t>(texel[2]) << 16;
  }
  std::string share(uint64_t part, uint64_t of) const {
    const double percent = of ? 100.0 * static_cast<double>(part) / static_cast<double>(of) : 0.0;
    return part > 0 && percent < 0.05 ? "<0.1%" : fmt::format("{:.1f}%", percent);
  }
  // Its name; with its number where it has none or shares it.
  std::string material_name(uint32_t material) const {
    const std::string& name = scene.materials[material].name;
    if (name.empty()) return fmt::format("material {}", material);
    const bool shared = std::ranges::count(scene.materials, name, &scene::Material::name) > 1;
    return shared ? fmt::format("{} #{}", name, material) : name;
  }
};

// The picture's colour at the first pixel without a surface.
void add_nothing_row(const Looking& l, const std::vector<uvec2>& visibility, std::vector<Row>& rows) {
  const auto is_nothing = [](uvec2 v) { return v == uvec2(kVisibilityNone); };
  const auto first = std::ranges::find_if(visibility, is_nothing);
  if (first == visibility.end()) return;
  const auto at = static_cast<uint32_t>(first - visibility.begin());
  const auto count = static_cast<uint64_t>(std::ranges::count_if(visibility, is_nothing));
  rows.push_back({l.image_at(at % l.result.size.width, at / l.result.size.width),
                  "no surface, " + l.share(count, visibility.size()) + " of the pixels", count});
}

std::vector<uint64_t> pixels_by_surface(const Looking& l, const std::vector<uvec2>& visibility) {
  std::vector<uint64_t> pixels(l.gathered.surfaces.size());
  for (const uvec2 v : visibility)
    if (v != uvec2(kVisibilityNone)) ++pixels.at(v.y & kVisibilitySurfaceMask);
  return pixels;
}

std::vector<Row> material_rows(const Looking& l) {
  const auto visibility = l.visibility();
  const auto colours = l.palette.input<uint32_t>("material_colours");
  const auto of_surface = pixels_by_surface(l, visibility);
  std::map<uint32_t, uint64_t> pixels_of;
  for (size_t i = 0; i < of_surface.size(); ++i)
    if (of_surface[i]) pixels_of[l.gathered.surfaces[i].material] += of_surface[i];
  std::vector<Row> rows;
  rows.reserve(pixels_of.size() + 1);
  for (const auto& [material, count] : pixels_of) {
    rows.push_back({colours[material],
                    fmt::format("{}, {}", l.material_name(material), l.share(count, visibility.size())), count});
  }
  add_nothing_row(l, visibility, rows);
  return rows;
}

std::vector<Row> triangle_rows(const Looking& l) {
  const auto visibility = l.visibility();
  std::vector<uint64_t> seen;  // surface and triangle
  for (const uvec2 v : visibility)
    if (v != uvec2(kVisibilityNone)) seen.push_back(uint64_t{v.y & kVisibilitySurfaceMask} << 32 | v.x);
  const auto covered = static_cast<double>(seen.size());
  std::ranges::sort(seen);
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  size_t surfaces = 0;
  for (size_t i = 0; i < seen.size(); ++i) surfaces += i == 0 || seen[i] >> 32 != seen[i - 1] >> 32;
  const double each = seen.empty() ? 0 : covered / static_cast<double>(seen.size());
  std::vector<Row> rows = {{0x808080,
                            fmt::format("a colour a triangle: {} triangles of {} surfaces, {:.1f} pixels a triangle",
                                        seen.size(), surfaces, each),
                            ~uint64_t{0}}};
  add_nothing_row(l, visibility, rows);
  return rows;
}

std::vector<Row> shader_rows(const Looking& l) {
  const auto visibility = l.visibility();
  const auto colours = l.palette.input<uint32_t>("shader_colours");
  const auto of_surface = pixels_by_surface(l, visibility);
  std::vector<uint64_t> pixels(l.gathered.shaders.size());
  for (size_t i = 0; i < of_surface.size(); ++i) pixels.at(l.gathered.surface_slots[i].shader) += of_surface[i];
  std::vector<Row> rows;
  for (size_t slot = 0; slot < pixels.size(); ++slot)
    rows.push_back(
        {colours[slot],
         fmt::format("{}, {}", kShaderNames[l.gathered.shaders[slot]], l.share(pixels[slot], visibility.size())),
         pixels[slot]});
  add_nothing_row(l, visibility, rows);
  return rows;
}

std::vector<Row> wave_rows(const Looking& l) {
  const auto status = l.words<CommandStatus>(kCommandStatus);
  std::vector<Row> rows;
  for (const CommandStatus& s : status) {
    const double lanes = static_cast<double>(s.waves) * kWaveSize;
    rows.push_back({0x808080,
                    fmt::format("a colour a wave: {} waves of {} lanes, {:.1f}% of the lanes shade", s.waves, kWaveSize,
                                lanes > 0 ? 100.0 * (s.pixels - s.overflow) / lanes : 0.0),
                    ~uint64_t{0}});
    if (s.overflow) rows.push_back({0x606060, fmt::format("{} pixels unpadded, for want of room", s.overflow), 1});
  }
  add_nothing_row(l, l.visibility(), rows);
  return rows;
}

// Heat by doublings of items, of all cells.
std::vector<Row> cluster_rows(const Looking& l) {
  const auto heat = l.palette.input<uint32_t>("heat_colours");
  const auto cells = l.words<uvec2>(kClusterCells);
  std::map<uint32_t, uint64_t> cells_of_heat;
  uint32_t most = 0;
  for (const uvec2 cell : cells) {
    const uint32_t items = (cell.y & kClusterItemMask) + (cell.y >> kClusterDecalShift & kClusterItemMask) +
                           (cell.y >> kClusterProbeShift);
    ++cells_of_heat[static_cast<uint32_t>(std::bit_width(items))];
    most = std::max(most, items);
  }
  std::vector<Row> rows;
  for (const auto& [doublings, count] : cells_of_heat) {
    const uint32_t least = doublings ? 1u << (doublings - 1) : 0;
    const std::string range = least < 2 ? fmt::format("{}", least) : fmt::format("{} to {}", least, 2 * least - 1);
    rows.push_back({heat[doublings],
                    fmt::format("{} item{}, {} of {} cells", range, least == 1 ? "" : "s", l.share(count, cells.size()),
                                cells.size()),
                    ~uint64_t{0} - doublings});
  }
  rows.push_back({0x808080, fmt::format("at most {} items in a cell", most), 1});
  add_nothing_row(l, l.visibility(), rows);
  return rows;
}

// Of the covered pixels.
std::vector<Row> rate_rows(const Looking& l) {
  const auto colours = l.palette.input<uint32_t>("vrcs_colours");
  const VrcsShares& v = l.result.vrcs;
  std::vector<Row> rows = {{colours[kColour1x1], "1x1, " + l.share(v.pixels_1x1, v.covered), v.pixels_1x1},
                           {colours[kColour1x2], "1x2, " + l.share(v.pixels_1x2, v.covered), v.pixels_1x2},
                           {colours[kColour2x1], "2x1, " + l.share(v.pixels_2x1, v.covered), v.pixels_2x1},
                           {colours[kColour2x2], "2x2, " + l.share(v.pixels_2x2, v.covered), v.pixels_2x2}};
  add_nothing_row(l, l.visibility(), rows);
  return rows;
}

std::vector<Row> primary_rows(const Looking& l) {
  const auto colours = l.palette.input<uint32_t>("vrcs_colours");
  const VrcsShares& v = l.result.vrcs;
  const uint64_t whole = v.tiles_1x1 + v.tiles_whole, mixed = v.tiles - v.tiles_sky - whole - v.tiles_2x2;
  const auto of_tiles = [&](uint64_t tiles) { return l.share(tiles, v.tiles) + " of the tiles"; };
  std::vector<Row> rows = {
      {0x808080, fmt::format("{} of the pixels are shaded", l.share(v.primaries, v.covered)), ~uint64_t{0}},
      {colours[kColourTileWhole], fmt::format("shaded whole, {}", of_tiles(whole)), whole},
      {colours[kColourTile2x2], fmt::format("2x2, one pixel of four shaded, {}", of_tiles(v.tiles_2x2)), v.tiles_2x2},
      {colours[kColourPrimary], fmt::format("primary pixel; mixed, {}", of_tiles(mixed)), mixed},
      {colours[kColourDuplicate], "duplicate pixel", mixed}};
  add_nothing_row(l, l.visibility(), rows);
  return rows;
}

std::vector<Row> shadow_rows(const Looking& l) {
  const ShadowCounts& n = l.gathered.shadow_counts;
  uint64_t texels = 0;
  for (const ShadowView& v : l.gathered.shadow_views) texels += uint64_t{v.tile.side} * v.tile.side;
  return {{0x808080,
           fmt::format("a colour a tile, brighter nearer to the light: {} tiles of {} lights, {} of {}x{} texels",
                       n.views, l.gathered.shadow_statistics.lights, l.share(texels, uint64_t{n.width} * n.height),
                       n.width, n.height),
           1}};
}

std::vector<Row> lit_rows(const Looking& l) {
  std::vector<Row> rows = {
      {0xffffff,
       fmt::format("{} surfaces of {} materials in {} shader classes, {} lights", l.gathered.surfaces.size(),
                   l.gathered.counts.visible_materials, l.gathered.shaders.size(), l.gathered.lights.size()),
       ~uint64_t{0}}};
  add_nothing_row(l, l.visibility(), rows);
  return rows;
}

// Heat by number of features, then the sets themselves in the colours of the squares that mark them, read off the
// picture.
std::vector<Row> tile_rows(const Looking& l) {
  const auto masks = l.words<uint32_t>("tile_classification.masks");
  const auto heat = l.palette.input<uint32_t>("heat_colours");
  const uint32_t across = ceil_div(l.result.size.width, kTileSide);
  std::map<int, uint64_t> tiles_of_heat;
  std::map<uint32_t, std::pair<uint64_t, uint32_t>> tiles_of_mask;  // how many, and the colour of the square
  for (uint32_t t = 0; t < masks.size(); ++t) {
    ++tiles_of_heat[std::popcount(masks[t])];
    auto& [count, colour] = tiles_of_mask[masks[t]];
    ++count;
    const uint32_t x = t % across * kTileSide + 4, y = t / across * kTileSide + 4;  // inside the square
    if (colour == 0 && x < l.result.size.width && y < l.result.size.height) colour = l.image_at(x, y);
  }
  std::vector<Row> rows;
  rows.reserve(tiles_of_heat.size() + tiles_of_mask.size());
  for (const auto& [bits, count] : tiles_of_heat)
    rows.push_back(
        {heat[static_cast<size_t>(bits)],
         fmt::format("{} feature{}, {} of the tiles", bits, bits == 1 ? "" : "s", l.share(count, masks.size())),
         ~uint64_t{0} - static_cast<uint64_t>(bits)});
  for (const auto& [mask, tiles] : tiles_of_mask)
    if (mask)
      rows.push_back(
          {tiles.second, fmt::format("{} {}", l.share(tiles.first, masks.size()), feature_names(mask)), tiles.first});
  return rows;
}

std::vector<Row> workload_rows(const Looking& l) {
  const auto colours = l.palette.input<uint32_t>("workload_colours");
  std::vector<Row> rows;
  for (size_t p = 0; p < l.result.statistics.size(); ++p) {
    const PassShare& pass = l.result.statistics[p];
    bool shown = false;
    size_t next = 0;
    for (size_t w = 0; w < std::size(kFrameWorkloads) && w < colours.size(); ++w) {
      if (kFrameWorkloads[w].row.pass != p) continue;
      const WorkloadShare& share = pass.workloads.at(next++);
      if (colours[w] == 0) continue;
      shown = true;
      rows.push_back(
          {colours[w],
           fmt::format("{} ({}), {} tiles, {:.1f}%", share.name, share.colour, share.tiles, 100 * share.share),
           share.tiles});
    }
    if (shown)
      rows.push_back(
          {0x302820, fmt::format("discarded by {}, {}", pass.name, l.share(pass.discarded, pass.theoretical)), 0});
  }
  return rows;
}

std::vector<Row> rows_of(const Looking& l, uint32_t view) {
  switch (view) {
    case kViewMaterial:
      return material_rows(l);
    case kViewTriangle:
      return triangle_rows(l);
    case kViewTile:
      return tile_rows(l);
    case kViewWorkload:
      return workload_rows(l);
    case kViewShader:
      return shader_rows(l);
    case kViewWave:
      return wave_rows(l);
    case kViewClusters:
      return cluster_rows(l);
    case kViewRate:
      return rate_rows(l);
    case kViewPrimary:
      return primary_rows(l);
    case kViewShadows:
      return shadow_rows(l);
    default:
      return lit_rows(l);
  }
}

}  // namespace

std::string feature_names(uint32_t mask) {
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
  for (const auto& [bit, name] : kFeatureNames)
    if (mask & bit) add(name), mask &= ~bit;
  if (mask) add(fmt::format("{:#x}", mask));
  return text.empty() ? "nothing" : text;
}

std::vector<image::LegendRow> legend_of(const Result& result, const scene::Scene& scene,
                                        const scene::Gathered& gathered, const Case& palette, uint32_t view) {
  const Looking l = {result, scene, gathered, palette};
  std::vector<Row> rows = rows_of(l, view);
  std::ranges::stable_sort(rows, std::greater(), &Row::count);
  const size_t more = rows.size() > kMostRows ? rows.size() - kMostRows : 0;
  rows.resize(rows.size() - more);
  if (more) rows.push_back({0x404040, fmt::format("and {} more", more), 0});
  std::vector<image::LegendRow> legend;
  legend.reserve(rows.size());
  for (const Row& r : rows)
    legend.push_back({static_cast<uint8_t>(r.colour), static_cast<uint8_t>(r.colour >> 8),
                      static_cast<uint8_t>(r.colour >> 16), r.text});
  return legend;
}

}  // namespace assay::frame
