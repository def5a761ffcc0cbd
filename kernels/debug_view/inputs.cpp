#include "kernels/debug_view/inputs.h"

#include <algorithm>
#include <numeric>

#include "harness/formats/material.h"
#include "kernels/debug_view/palette.h"
#include "kernels/debug_view/picture.h"

namespace assay::debug_view {
namespace {

void add_rectangles(Picture& p, Pcg32& rng, uint32_t count) {
  const auto surfaces = static_cast<uint32_t>(p.surface_materials.size());
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x0 = rng.below(p.extent.width), y0 = rng.below(p.extent.height), surface = rng.below(surfaces);
    const uint32_t x1 = std::min(p.extent.width, x0 + 1 + rng.below(p.extent.width / 3 + 8));
    const uint32_t y1 = std::min(p.extent.height, y0 + 1 + rng.below(p.extent.height / 3 + 8));
    const uint32_t flags = rng.next() & (kVisibilityInstanced | kVisibilityFlipped), coarse = 1 + rng.below(9);
    for (uint32_t y = y0; y < y1; ++y)
      for (uint32_t x = x0; x < x1; ++x) p.at(x, y) = {(x / coarse) ^ (y / coarse), surface | flags};
  }
}

// Every tile in at most one list, as classification leaves them.
void add_partition(Picture& p, Pcg32& rng, uint32_t rows) {
  std::vector<std::vector<uint32_t>> tiles(rows + 1);
  for (uint32_t t = 0; t < p.tile_total(); ++t) tiles[rng.below(rows + 1)].push_back(t);
  for (uint32_t row = 0; row < rows; ++row)
    p.lists.push_back(list_of(tiles[row], rng.below(6) ? rng.next() | 1u : 0u, 1 + rng.below(40)));
}

// Tiles that do not exist or are listed twice in one list, counts beyond the list, dispatches of too few, too many or
// no groups. Two lists share no tile: the rows of a repeated pass are not ordered among each other.
void add_hostile_lists(Picture& p, Pcg32& rng, uint32_t rows) {
  for (uint32_t row = 0; row < rows; ++row) {
    List list;
    for (uint32_t i = 0; i < p.tile_total(); ++i) {
      const uint32_t own = rng.below(p.tile_total() / rows + 1) * rows + row;  // at most a few beyond the last tile
      list.tiles.push_back(rng.below(8) ? own : p.tile_total() + rng.below(~0u - p.tile_total()));
    }
    list.counted = rng.below(4) ? rng.below(p.tile_total() + 3) : rng.next();
    list.args = {rng.below(5), rng.below(12), rng.below(5)};
    list.colour = rng.next();
    p.lists.push_back(std::move(list));
  }
}

Case with_lists(Extent e, std::vector<List> lists) {
  Picture p = busy_picture(e, kViewWorkload);
  p.lists = std::move(lists);
  return to_case(p);
}

std::vector<uint32_t> first_tiles(uint32_t n, uint32_t first = 0) {
  std::vector<uint32_t> tiles(n);
  std::iota(tiles.begin(), tiles.end(), first);
  return tiles;
}

// Every pixel of the screen once, in random order.
std::vector<uvec2> shuffled_pixels(Extent e, Pcg32& rng) {
  std::vector<uvec2> all;
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) all.emplace_back(x, y);
  for (size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[rng.below(static_cast<uint32_t>(i))]);
  return all;
}

void add_waves(Picture& p, Pcg32& rng, uint32_t shaders) {
  p.shader_colours.resize(shaders);
  p.waves = wave_lists(p.extent, shaders, shuffled_pixels(p.extent, rng), rng);
}

// Slots in turn, one of eight unregistered.
void add_slots(Picture& p, Pcg32& rng, uint32_t shaders) {
  p.shader_colours = shader_palette(shaders);
  for (size_t i = 0; i < p.surface_materials.size(); ++i)
    p.slots.push_back({rng.below(8) ? rng.below(shaders) : kUnregistered, rng.next()});
}

}  // namespace

Case random_case(Random& r) {
  const Extent extent = random_extent(r, kTileSide);
  const size_t view = r.branch({{"view_material", 1},
                                {"view_triangle", 1},
                                {"view_tile", 1},
                                {"view_workload", 2},
                                {"view_shader", 1},
                                {"view_wave", 1},
                                {"view_clusters", 1},
                                {"view_rate", 1},
                                {"view_primary", 1},
                                {"view_shadows", 1},
                                {"view_unknown", 0.2}});
  const uint32_t views[] = {kViewMaterial, kViewTriangle, kViewTile,    kViewWorkload, kViewShader, kViewWave,
                            kViewClusters, kViewRate,     kViewPrimary, kViewShadows,  77};
  Picture p = empty_picture(extent, views[view], 1 + r.rng.below(200), 1 + r.rng.below(40));
  for (uint32_t& c : p.material_colours) c = r.rng.next();
  for (uint32_t& m : p.masks) m = r.rng.below(5) ? r.rng.next() & r.rng.next() & r.rng.next() : 0;
  add_rectangles(p, r.rng, r.rng.below(40));
  if (r.branch({{"indices_in_range", 0.8}, {"indices_out_of_range", 0.2}})) {
    for (uint32_t& m : p.surface_materials)
      if (r.rng.below(4) == 0) m = r.rng.next() % 60;
    for (uvec2& v : p.visibility)
      if (r.rng.below(8) == 0) v = {r.rng.next(), r.rng.below(2) ? r.rng.next() : r.rng.below(300)};
  }
  switch (r.branch({{"lists_none", 0.1}, {"lists_partition", 0.7}, {"lists_hostile", 0.2}})) {
    case 0:
      break;
    case 1:
      add_partition(p, r.rng, 1 + r.rng.below(8));
      break;
    default:
      add_hostile_lists(p, r.rng, 1 + r.rng.below(8));
  }
  if (p.view == kViewShader) add_slots(p, r.rng, 1 + r.rng.below(kShaderClasses));
  if (p.view == kViewWave) add_waves(p, r.rng, 1 + r.rng.below(kShaderClasses));
  if (p.view == kViewClusters) add_cells(p, r.rng, 1u << r.rng.below(9));
  if (p.view == kViewRate || p.view == kViewPrimary) add_vrcs(p, r.rng);
  if (p.view == kViewShadows) add_shadows(p, r.rng, {32u << r.rng.below(5), 32u << r.rng.below(5)});
  Case c = to_case(p);
  c.name = "random";
  return c;
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b : {"view_material", "view_triangle", "view_tile", "view_workload", "view_shader", "view_wave",
                        "view_clusters", "view_rate", "view_primary", "view_shadows", "view_unknown",
                        "indices_in_range", "indices_out_of_range", "lists_none", "lists_partition", "lists_hostile"})
    all.push_back(b);
  return all;
}

std::vector<HardCase> hard_cases() {
  const auto busy = [](Extent e, uint32_t view) { return [=] { return to_case(busy_picture(e, view)); }; };
  const auto vrcs = [](Extent e, uint32_t view) {
    return [=] {
      Picture p = busy_picture(e, view);
      Pcg32 rng(8);
      add_vrcs(p, rng);
      return to_case(p);
    };
  };
  const uint32_t red = named_colour("RED"), green = named_colour("GREEN"), blue = named_colour("BLUE");
  return {
      {"one_pixel", "one lane of one group", busy({1, 1}, kViewMaterial)},
      {"one_group_and_one", "a second group for one column and one row", busy({17, 17}, kViewTriangle)},
      {"odd_extent_material", "rows start inside a subgroup and inside a run", busy({31, 33}, kViewMaterial)},
      {"odd_extent_tile", "partial tiles on both edges", busy({70, 45}, kViewTile)},
      {"tile_and_less_one", "one pixel short of two tiles", busy({63, 31}, kViewTile)},
      {"unknown_view", "a view that does not exist shows materials", busy({40, 40}, 77)},
      {"same_triangle_other_surface", "the triangle view must tell surfaces apart",
       [] {
         Picture p = empty_picture({64, 64}, kViewTriangle, 64, 3);
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 64; ++x) p.at(x, y) = {5, x};
         return to_case(p);
       }},
      {"same_surface_other_triangle", "a run of pixels of one surface, each another triangle",
       [] {
         Picture p = empty_picture({64, 64}, kViewTriangle, 1, 1);
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 64; ++x) p.at(x, y) = {x + 64 * y, 0};
         return to_case(p);
       }},
      {"flags", "the instanced and flipped bits are no part of the index", busy({64, 64}, kViewMaterial)},
      {"every_feature", "masks of 0, 1, 31 and 32 bits, the highest bit alone",
       [] {
         Picture p = empty_picture({5 * 32, 32}, kViewTile, 1, 1);
         std::fill(p.visibility.begin(), p.visibility.end(), uvec2(0));
         p.masks = {0, 1, 0x7fffffff, 0xffffffff, 0x80000000};
         return to_case(p);
       }},
      {"half_nothing",
       "x or y alone all ones is not the empty pixel: surface 2^30 - 1 is broken, triangle 2^32 - 1 is fine",
       [] {
         Picture p = empty_picture({64, 64}, kViewMaterial, 2, 2);
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 64; ++x) p.at(x, y) = x % 2 ? uvec2(kVisibilityNone, 1) : uvec2(1, kVisibilityNone);
         return to_case(p);
       }},
      {"broken_indices", "surface and material at and beyond their counts",
       [] {
         Picture p = empty_picture({64, 64}, kViewMaterial, 4, 4);
         p.surface_materials = {0, 4, 5, 0xffffffff};
         for (uint32_t y = 0; y < 64; ++y)
           for (uint32_t x = 0; x < 64; ++x) p.at(x, y) = {x, (x + y) % 6};
         return to_case(p);
       }},
      {"lists_disjoint", "three workloads on three tiles, the rest discarded",
       [=] {
         return with_lists({130, 70}, {list_of({3, 0}, red), list_of({7}, green), list_of({14, 9}, blue)});
       }},
      {"last_column_only", "a partial tile at the right edge: its missing columns are the next row's first",
       [=] {
         return with_lists({33, 40}, {list_of({1}, red)});
       }},
      {"few_groups_a_tile", "one and three groups share a tile's 1024 pixels unevenly",
       [=] {
         return with_lists({96, 64}, {list_of({0, 1, 2}, red, 1), list_of({3, 4, 5}, green, 3)});
       }},
      {"many_groups_a_tile", "more groups than a tile has pixels for",
       [=] {
         return with_lists({64, 64}, {list_of({0, 1, 2, 3}, red, 100)});
       }},
      {"stale_entries", "the dispatch launches more groups than the list has tiles, and stale tiles follow it",
       [=] {
         return with_lists({96, 96}, {{{0, 1, 2, 3, 4, 5}, 3, {32, 3, 2}, red}});
       }},
      {"spread_over_z", "the list's groups lie in two dimensions",
       [=] {
         return with_lists({128, 96}, {{first_tiles(11, 1), 11, {32, 4, 3}, red}});
       }},
      {"tile_out_of_range", "listed tiles that do not exist are left alone",
       [=] {
         return with_lists({64, 64}, {{{4, 0, 0xffffffff, 5}, 4, {32, 4, 1}, red}});
       }},
      {"count_overflows", "a count of 2^32 - 1: no more than the list's room is read",
       [=] {
         // Behind the first list's room lies tile 3, which only a pass that is not shown lists.
         return with_lists({64, 64}, {{{0, 1, 2, ~0u}, ~0u, {32, 9, 1}, red}, list_of({3}, 0)});
       }},
      {"empty_lists", "indirect dispatches of no groups",
       [=] {
         return with_lists({64, 64}, {list_of({}, red), list_of({}, green)});
       }},
      {"pass_not_shown", "colour 0 leaves its tiles as they are",
       [=] {
         return with_lists({64, 64}, {list_of({0, 1}, 0), list_of({2}, green)});
       }},
      {"slots", "shader slots in turn, at and behind the last, unregistered; material slots that differ",
       [] {
         Picture p = busy_picture({64, 64}, kViewShader);
         p.shader_colours = shader_palette(4);
         for (uint32_t i = 0; i < p.surface_materials.size(); ++i)
           p.slots.push_back({i % 6 == 5 ? kUnregistered : i % 6, (i + 1) % 4});
         return to_case(p);
       }},
      {"waves", "two slots, every bucket, waves filled in part",
       [] {
         Picture p = busy_picture({190, 133}, kViewWave);
         Pcg32 rng(3);
         add_waves(p, rng, 2);
         return to_case(p);
       }},
      {"waves_off_screen", "entries whose column or row is not on the screen are left alone",
       [] {
         Picture p = busy_picture({70, 40}, kViewWave);
         Pcg32 rng(4);
         p.shader_colours.resize(1);
         std::vector<uvec2> pixels;
         for (uint32_t i = 0; i < 1500; ++i) pixels.emplace_back(70 + i % 60, i / 60 * 2);
         p.waves = wave_lists(p.extent, 1, pixels, rng);
         return to_case(p);
       }},
      {"cells", "none, one, three and more items of each kind and of all; depths on the slices' boundaries",
       [] {
         Picture p = busy_picture({100, 90}, kViewClusters);
         Pcg32 rng(6);
         add_cells(p, rng, 3);
         return to_case(p);
       }},
      {"full_cells", "256, 256 and 255 items: the hottest colour",
       [] {
         Picture p = busy_picture({70, 50}, kViewClusters);
         Pcg32 rng(7);
         add_cells(p, rng, 256);
         return to_case(p);
       }},
      {"no_cells", "the clusters view of a grid without cells",
       [] {
         return to_case(busy_picture({33, 31}, kViewClusters));
       }},
      {"rates", "every rate and unknown ones; an odd extent, whose last cells are cut", vrcs({101, 67}, kViewRate)},
      {"primaries", "copy bits and tiles of every kind, of 223 to 226 primaries; partial tiles on both edges",
       vrcs({169, 90}, kViewPrimary)},
      {"shadows", "an atlas wider than the picture; tiles of all sizes with gaps, depths of every doubling",
       [] {
         Picture p = busy_picture({150, 130}, kViewShadows);
         Pcg32 rng(8);
         add_shadows(p, rng, {256, 128});
         return to_case(p);
       }},
      {"tall_atlas", "an atlas higher than the picture, of less than a texel a pixel",
       [] {
         Picture p = busy_picture({301, 200}, kViewShadows);
         Pcg32 rng(9);
         add_shadows(p, rng, {32, 64});
         return to_case(p);
       }},
      {"no_atlas", "the shadows view without any light that casts one",
       [] {
         return to_case(busy_picture({33, 31}, kViewShadows));
       }},
      {"no_shader", "the shader and wave views of a scene without any",
       [] {
         Picture p = busy_picture({33, 31}, kViewWave);
         Pcg32 rng(5);
         add_waves(p, rng, 0);
         return to_case(p);
       }},
      {"full_hd_and_one", "an odd extent of real size",
       [=] {
         return with_lists({1921, 1081}, {list_of(first_tiles(2074), blue)});
       }},
      {"ultra_hd", "3840x2160, every tile shaded",
       [=] {
         return with_lists({3840, 2160}, {list_of(first_tiles(8160), red)});
       },
       true},
  };
}

std::vector<Case> smaller(const Case& c) {
  // Fewer pixels would renumber the tiles; fewer things to look at explain a failure as well.
  std::vector<Case> found;
  const auto visibility = c.input<uvec2>("visibility");
  for (const bool upper : {true, false}) {
    std::vector<uvec2> cleared(visibility.begin(), visibility.end());
    const size_t half = cleared.size() / 2;
    const auto begin = cleared.begin() + (upper ? 0 : static_cast<ptrdiff_t>(half));
    const auto end = upper ? cleared.begin() + static_cast<ptrdiff_t>(half) : cleared.end();
    if (std::all_of(begin, end, [](uvec2 v) { return v == uvec2(kVisibilityNone); })) continue;
    std::fill(begin, end, uvec2(kVisibilityNone));
    found.push_back(c);
    found.back().set_input("visibility", cleared);
  }
  const auto counts = c.input<WorkloadCount>("workload_counts");
  for (size_t row = 0; row < counts.size(); ++row) {
    if (counts[row].tiles == 0) continue;
    std::vector<WorkloadCount> fewer(counts.begin(), counts.end());
    fewer[row].tiles /= 2;
    found.push_back(c);
    found.back().set_input("workload_counts", fewer);
  }
  return found;
}

Case typical(Extent extent) {
  Pcg32 rng(1);
  Picture p = empty_picture(extent, kViewWorkload, 400, 60);
  add_rectangles(p, rng, 250);
  std::vector<uint32_t> even, odd;
  for (uint32_t t = 0; t < p.tile_total(); ++t) (t % 3 ? even : odd).push_back(t);
  p.lists = {list_of(even, named_colour("GREEN")), list_of(odd, named_colour("RED"))};
  Case c = to_case(p);
  c.name = "typical";
  return c;
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  const auto rows = static_cast<uint32_t>(std::size(kFrameWorkloads));
  c.set_params(ViewParams{f.extent.width, f.extent.height, f.view, f.scene.surfaces, f.scene.materials, rows,
                          static_cast<uint32_t>(f.shaders.size()), f.grid, f.shadows.width, f.shadows.height,
                          f.shadows.views});
  std::vector<uint32_t> shader_colours;
  for (const uint32_t shader : f.shaders) shader_colours.push_back(shader_palette(kShaderClasses)[shader]);
  c.set_input("shader_colours", shader_colours);
  c.set_input("material_colours", material_palette(f.scene.materials));
  c.set_input("heat_colours", heat_palette());
  c.set_input("vrcs_colours", vrcs_palette());
  // One pass at a time can be shown, and the last is the one that shades every tile with a surface.
  std::vector<uint32_t> colours;
  for (const FrameWorkload& w : kFrameWorkloads)
    colours.push_back(w.row.pass + 1 == std::size(kFramePasses) ? named_colour(w.colour) : 0);
  c.set_input("workload_colours", colours);
  return c;
}

}  // namespace assay::debug_view
