// Hard cases of primaries and copies.
#include <algorithm>

#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/workloads.h"
#include "harness/vrcs_lists.h"
#include "harness/vrcs_screens.h"
#include "kernels/deferred_lighting/inputs.h"
#include "kernels/deferred_lighting/picture.h"

namespace assay::deferred_lighting {

namespace {

using vrcs::drawn, vrcs::of_one, vrcs::Pictured;
using Words = std::vector<uint>;

// A wall, with depth where the screen is covered, of which no two pixels look alike: a copy is never what its own pixel
// would have been.
Picture motley(const Pictured& s, uint frame) {
  Picture p = wall(s.extent);
  Pcg32 rng(frame + 5);
  for (size_t i = 0; i < p.depth.size(); ++i) {
    p.base[i] = rng.next() | 0x404040u;
    if (s.visibility[i] == uvec2(kVisibilityNone)) p.depth[i] = 0;
  }
  p.lights = {directional({0.3, -0.2, -1}, vec3(3, 2, 1)), point({0.5, 0.5, -1.5}, 9, vec3(4, 8, 12))};
  p.visibility = s.visibility;
  p.rates = s.rates;
  p.params.frame = frame;
  return p;
}
Case made(const Pictured& s, uint frame = 0) { return to_case("", motley(s, frame)); }

Pictured of_own(Extent e) {
  return drawn(e, kRate2x2, [](uint x, uint y) { return uvec2(y * 16384 + x, 1); });
}
Pictured with_sky(Pictured s, std::initializer_list<uvec2> pixels) {
  for (const uvec2 at : pixels) s.visibility[s.place(at.x, at.y)] = uvec2(kVisibilityNone);
  return s;
}

// Of each nine pixels one has depth and nothing covers it, and one is covered and has no depth; tiles at 2x2, and tiles
// that are shaded whole.
Case covered_elsewhere() {
  Picture p = motley(
      drawn({64, 40}, kRate2x2, [](uint x, uint y) { return x / 16 % 2 ? uvec2(y * 64 + x, 1) : uvec2(x / 5, 1); }), 2);
  for (size_t i = 0; i < p.depth.size(); i += 9) p.visibility[i] = uvec2(kVisibilityNone);
  for (size_t i = 4; i < p.depth.size(); i += 9) p.depth[i] = 0;
  return to_case("", p);
}

// A dispatch may be of one group a row.
Case one_group_a_row() {
  Case c = made(of_own({37, 35}));
  const uint groups = ceil_div(c.input<uint>("list_count")[0], kVrcsListGroup);
  c.set_input("list_args", std::vector{DispatchArgs{1, groups, 1}});
  return c;
}

Case hall_at(uint8_t rate) {
  Case c = typical({1920, 1080});
  const auto visibility = c.input<uvec2>("visibility");
  set_primaries(c, {.extent = c.extent,
                    .params = c.params<LightingParams>(),
                    .visibility = {visibility.begin(), visibility.end()},
                    .rates = std::vector<uint8_t>(pixel_count(vrcs::cells_of(c.extent)), rate)});
  return c;
}

}  // namespace

std::vector<HardCase> sound_primaries() {
  return {
      {"all_sky", "all of it is background",
       [] {
         return made(vrcs::empty_screen({48, 40}));
       }},
      {"one_pixel_of_sky", "background in tiles that have a list, in the last column and row too",
       [] {
         return made(with_sky(of_one({37, 35}, kRate2x2), {{5, 7}, {36, 34}, {20, 34}, {36, 3}}), 1);
       }},
      {"one_pixel_covered", "a tile of one primary, the rest background",
       [] {
         return made(drawn({33, 32}, kRate2x2,
                           [](uint x, uint y) { return x == 21 && y == 9 ? uvec2(1, 1) : uvec2(kVisibilityNone); }));
       }},
      {"all_2x2", "no entries: the pixels are worked out",
       [] {
         return made(of_one({64, 48}, kRate2x2));
       }},
      {"all_2x2_odd_frame", "and the lower right ones",
       [] {
         return made(of_one({64, 48}, kRate2x2), 5);
       }},
      {"all_2x1", "pairs side by side",
       [] {
         return made(of_one({40, 24}, kRate2x1), 3);
       }},
      {"all_1x2", "pairs one below the other",
       [] {
         return made(of_one({40, 24}, kRate1x2), 2);
       }},
      {"all_1x1", "every pixel is a primary: as if there were no rates",
       [] {
         return made(of_one({45, 33}, kRate1x1));
       }},
      {"cut_cells", "copies end at the screen's sides",
       [] {
         return made(of_one({37, 35}, kRate2x2), 1);
       }},
      {"primaries_224", "the longest list",
       [] {
         return made(vrcs::of_primaries({48, 32}, 32));
       }},
      {"primaries_225", "one more, and every pixel is shaded",
       [] {
         return made(vrcs::of_primaries({48, 32}, 33));
       }},
      {"holes_where_all_are_shaded", "over 224 primaries, and background between them",
       [] {
         return made(with_sky(of_own({48, 33}), {{0, 0}, {15, 15}, {16, 0}, {40, 20}, {47, 32}}));
       }},
      {"diagonals", "a checkerboard: two primaries a cell, each copied across",
       [] {
         return made(drawn({64, 48}, kRate2x2, [](uint x, uint y) { return uvec2((x + y) % 2, 1); }), 1);
       }},
      {"short_lists", "lists of 1 to 16 primaries: one wave of many",
       [] {
         return made(drawn({256, 16}, kRate2x2, [](uint x, uint y) {
           return y == 5 && x % 16 <= x / 16 ? uvec2(x, 1) : uvec2(kVisibilityNone);
         }));
       }},
      {"covered_elsewhere", "depth where nothing covers, none where something does", covered_elsewhere},
      {"rows_of_groups", "a dispatch over the screen's list of one group a row", one_group_a_row},
      {"hall_at_1x1", "the typical input, every pixel a primary: for timing", [] { return hall_at(kRate1x1); }, true},
      {"hall_at_2x2", "the typical input at the coarsest rate: for timing", [] { return hall_at(kRate2x2); }, true},
  };
}

namespace {

Case holed() { return made(with_sky(of_one({75, 61}, kRate2x1), {{3, 3}, {40, 50}, {74, 60}, {74, 2}}), 1); }

std::vector<HardCase> hostile_primaries() {
  return {
      {"full_by_flag", "tiles with background, or cut by a side, that say they are all 2x2, by too few primaries",
       [] { return vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, kVrcsTile2x2 | 40); }); }},
      {"full_by_word", "and by as many as a full tile has: background is copied over",
       [] { return vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, kVrcsTile2x2 | 64); }); }},
      {"counts_over", "counts of more pixels than a tile has: all are shaded",
       [] {
         return vrcs::changed(holed(), "tiles", [](Words& w) {
           for (size_t i = 0; i < w.size(); ++i) w[i] = 225 + static_cast<uint>(i) * 14;
         });
       }},
      {"words_of_ones", "every flag, every count",
       [] { return vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 0xffffffffu); }); }},
      {"words_of_none", "no primaries in covered tiles: all background",
       [] { return vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 0xfffffe00u); }); }},
      {"entries_off_screen", "pixels beyond either side, copied back onto the screen; invalid ones",
       [] {
         // 75 is the first column off the screen, 61 the first row.
         Case c = vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 1); });
         c = vrcs::changed(c, "tile_entries", [](Words& w) { std::ranges::fill(w, 11 | 13 << 4 | 7 << 8); });
         return vrcs::changed(c, "list", [](Words& w) {
           const uint kOdd[] = {75 | 58u << 14 | 1u << 28,
                                70 | 61u << 14 | 2u << 28,
                                75 | 61u << 14 | 7u << 28,
                                0x0fffffff,
                                0x80000000,
                                0xffffffff};
           for (size_t i = 0; i < w.size(); ++i) w[i] = kOdd[i % 6];
         });
       }},
      {"copies_off_screen", "pixels in the last column and row, copied beyond",
       [] {
         Case c = vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 1); });
         c = vrcs::changed(c, "tile_entries", [](Words& w) { std::ranges::fill(w, 10 | 12 << 4 | 7 << 8); });
         return vrcs::changed(c, "list", [](Words& w) { std::ranges::fill(w, 74 | 60 << 14 | 7u << 28); });
       }},
      {"pixels_listed_twice", "each entry one pixel of two, that the other copies too: either comes out",
       [] {
         Case c = vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 100); });
         c = vrcs::changed(c, "list", [](Words& w) {
           for (size_t i = 0; i < w.size(); ++i) w[i] = (34 + static_cast<uint>(i % 2)) | 18 << 14 | 7u << 28;
         });
         return vrcs::changed(c, "tile_entries", [](Words& w) {
           for (size_t i = 0; i < w.size(); ++i) w[i] = 0x722 | static_cast<uint>(i % 2);
         });
       }},
      {"entries_of_ones", "the last pixel of each tile, again and again, copied everywhere, onto background too",
       [] {
         Case c = vrcs::changed(holed(), "tiles", [](Words& w) { std::ranges::fill(w, 100); });
         c = vrcs::changed(c, "list", [](Words& w) { std::ranges::fill(w, 0x7fffffffu); });
         return vrcs::changed(c, "tile_entries", [](Words& w) { std::ranges::fill(w, 0xffffffffu); });
       }},
      {"list_too_long", "a count beyond the list, in a dispatch of more groups than it has",
       [] {
         Case c = vrcs::changed(holed(), "list_count", [](Words& w) { w[0] = 0xffffffff; });
         c.set_input("list_args", std::vector{DispatchArgs{100, 2, 1}});
         return c;
       }},
  };
}

}  // namespace

std::vector<HardCase> primary_cases() {
  std::vector<HardCase> all = sound_primaries();
  for (auto& more : hostile_primaries()) all.push_back(more);
  return all;
}

}  // namespace assay::deferred_lighting
