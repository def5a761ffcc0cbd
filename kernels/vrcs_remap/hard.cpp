// Named hard cases, and the faults that they must find.
#include <algorithm>

#include "kernels/vrcs_remap/inputs.h"

namespace assay::vrcs_remap {

namespace {

using vrcs::drawn, vrcs::of_one, vrcs::Pictured;

Pictured of_own(Extent e) {
  return drawn(e, kRate2x2, [](uint x, uint y) { return uvec2(y * 16384 + x, 1); });
}
Case made(const Pictured& s, uint frame = 0) { return case_of(s.view(frame), 3); }

Case primaries(uint more_than_192) { return made(vrcs::of_primaries({48, 32}, more_than_192)); }

std::vector<HardCase> lists() {
  return {
      {"all_sky", "nothing is stored, no wave has work",
       [] {
         return made(vrcs::empty_screen({48, 40}));
       }},
      {"all_2x2", "no entries: the pixels are worked out, two waves of 32 a tile",
       [] {
         return made(of_one({64, 48}, kRate2x2));
       }},
      {"all_2x2_odd_frame", "and the lower right ones",
       [] {
         return made(of_one({64, 48}, kRate2x2), 5);
       }},
      {"cut_cells", "copies end at the screen's sides",
       [] {
         return made(of_one({37, 35}, kRate2x2), 1);
       }},
      {"primaries_224", "the longest list", [] { return primaries(32); }},
      {"primaries_225", "one more, and every pixel is shaded", [] { return primaries(33); }},
      {"holes_where_all_are_shaded", "over 224 primaries, and pixels without a surface between them",
       [] {
         Pictured s = of_own({48, 33});
         for (size_t i = 0; i < s.visibility.size(); i += 11) s.visibility[i] = uvec2(kVisibilityNone);
         return made(s);
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
      {"fogged", "tiles beyond the fog's depth, and others",
       [] {
         Pictured s = of_one({96, 48}, kRate2x1);
         for (size_t i = 0; i < s.depth.size(); i += 7) s.depth[i] = i / 48 % 3 == 0 ? 0.001f : 0.1f;
         vrcs::View view = s.view(2);
         view.fog_depth = 0.005f;
         return case_of(view, 3);
       }},
      {"rows_of_groups", "a list of more groups than a dimension of a dispatch holds",
       [] {
         return made(of_own({2049, 2048}));
       }},
  };
}

std::vector<HardCase> hostile_lists() {
  const auto base = [] { return made(vrcs::typical_screen({75, 61}), 1); };
  return {
      {"counts_over", "counts of more pixels than a tile has: all are shaded",
       [=] {
         return hostile(base(), "tiles", [](std::vector<uint>& words) {
           for (size_t i = 0; i < words.size(); ++i) words[i] = 224 + static_cast<uint>(i) * 15;
         });
       }},
      {"words_of_ones", "every flag, every count",
       [=] {
         return hostile(base(), "tiles", [](std::vector<uint>& words) { std::ranges::fill(words, 0xffffffffu); });
       }},
      {"worked_out_beyond_the_screen", "tiles cut by a side that say they are all 2x2",
       [=] {
         return hostile(base(), "tiles",
                        [](std::vector<uint>& words) { std::ranges::fill(words, kVrcsTile2x2 | 200); });
       }},
      {"entries_of_ones", "pixels off the screen, copied everywhere",
       [=] {
         Case c = hostile(base(), "tiles", [](std::vector<uint>& words) { std::ranges::fill(words, 100); });
         c = hostile(c, "list", [](std::vector<uint>& words) { std::ranges::fill(words, 0x7fffffffu); });
         return hostile(c, "entries", [](std::vector<uint>& words) { std::ranges::fill(words, 0xffffffffu); });
       }},
      {"pixels_listed_twice", "each entry one pixel of two",
       [=] {
         Case c = hostile(base(), "tiles", [](std::vector<uint>& words) { std::ranges::fill(words, 100); });
         c = hostile(c, "list", [](std::vector<uint>& words) {
           for (size_t n = 0; n < words.size(); ++n) words[n] = (34 + static_cast<uint>(n % 2)) | 18 << 14;
         });
         return hostile(c, "entries", [](std::vector<uint>& words) {
           for (size_t i = 0; i < words.size(); ++i) words[i] = 0x722 | static_cast<uint>(i % 2);
         });
       }},
      {"copies_off_screen", "pixels in the last column and row, copied beyond",
       [=] {
         Case c = hostile(base(), "tiles", [](std::vector<uint>& words) { std::ranges::fill(words, 1); });
         c = hostile(c, "entries", [](std::vector<uint>& words) { std::ranges::fill(words, 0x7ca); });
         return hostile(c, "list",
                        [](std::vector<uint>& words) { std::ranges::fill(words, 74 | 60 << 14 | 7u << 28); });
       }},
      {"list_off_screen", "entries beyond either side, invalid ones, copies beyond the last column and row",
       [=] {
         return hostile(base(), "list", [](std::vector<uint>& words) {
           const uint kOdd[] = {74 | 60u << 14 | 7u << 28, 75, 61u << 14, 0x0fffffff, 0x80000000, 0xffffffff};
           for (size_t i = 0; i < words.size(); ++i) words[i] = kOdd[i % 6];
         });
       }},
      {"list_too_long", "a count beyond the list",
       [=] { return hostile(base(), "list_count", [](std::vector<uint>& words) { words[0] = 0xffffffff; }); }},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases;
  for (const Extent e : {Extent{1, 1}, {2, 1}, {15, 17}, {16, 16}, {17, 15}, {31, 33}, {1, 2049}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = lists();
  for (auto& more : {hostile_lists(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"visit.glsl", 1, "a copy comes out as its own place", "all_2x2"},
      {"visit.glsl", 2, "stores are not counted", "pixels_listed_twice"},
      {"tile.glsl", 3, "lanes of a subgroup are not side by side in the list", "short_lists"},
      {"tile.glsl", 4, "sky is shaded", "all_sky"},
      {"tile.glsl", 5, "pixels without a surface are shaded where all are", "holes_where_all_are_shaded"},
      {"tile.glsl", 6, "the depth of an entry is dropped", "entries_of_ones"},
      {"compact.comp", 7, "one row of groups", "rows_of_groups"},
      {"compact.comp", 8, "the last thread of a group has nothing to do", "cut_cells"},
      {"harness/glsl/vrcs.glsl", 9601, "lists are trusted", "entries_of_ones"},
      {"harness/glsl/vrcs.glsl", 9602, "the last list that saves a wave is not taken", "primaries_224"},
      {"harness/glsl/vrcs.glsl", 9603, "one lane too many", "short_lists"},
      {"harness/glsl/vrcs.glsl", 9604, "the upper left pixel in every frame", "all_2x2_odd_frame"},
      {"harness/glsl/vrcs.glsl", 9605, "copies beyond the screen's last column and row", "copies_off_screen"},
      {"harness/glsl/vrcs.glsl", 9606, "the diagonal is forgotten", "all_2x2"},
  };
}

}  // namespace assay::vrcs_remap
