// Named hard cases, and the faults that they must find.
#include <bit>
#include <cmath>
#include <limits>

#include "harness/half.h"
#include "kernels/vrcs_deblock/inputs.h"

namespace assay::vrcs_deblock {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

// Every pixel and channel another value; no mean of neighbours is the pixel's own.
Texel speckle(uint x, uint y) {
  const auto h = [&](uint salt) { return static_cast<uint16_t>(0x2c00 + (x * 397 + y * 2503 + salt * 811) % 0x1400); };
  return {h(1), h(2), h(3), 0x3c00};
}
Picture speckled(Extent e, uint rate, uint frame = 0) { return at_rate(painted(e, speckle), rate, frame); }

std::function<Case()> made(std::function<Picture()> make) {
  return [make = std::move(make)] { return case_of(make()); };
}
HardCase hard(const char* name, const char* why, std::function<Picture()> make) {
  return {name, why, made(std::move(make))};
}
// With lists that are not the picture's own.
HardCase listed(const char* name, const char* why, std::function<Picture()> make,
                std::function<void(const Picture&, Lists&)> change) {
  return {name, why, [make = std::move(make), change = std::move(change)] {
            const Picture p = make();
            Lists lists = lists_of(p);
            change(p, lists);
            return case_of(p, lists);
          }};
}

// A tile of so many primaries: cells from the first on at 1x1, the others 2x2, one of them a pair.
Picture with_primaries(uint count) {
  Picture p = speckled({16, 16}, kRate2x2);
  uint left = count - 64;  // three more for a cell at 1x1, one more at 2x1
  for (uint8_t& rate : p.rates) {
    if (left >= 3)
      rate = kRate1x1, left -= 3;
    else if (left > 0)
      rate = kRate2x1, --left;
  }
  return p;
}

std::vector<HardCase> list_cases() {
  return {
      hard("all_1x1", "nothing changes, bit for bit",
           [] {
             return speckled({48, 40}, kRate1x1);
           }),
      hard("rate_1x2", "vertical duplicates alone",
           [] {
             return speckled({48, 40}, kRate1x2);
           }),
      hard("rate_2x1", "horizontal duplicates alone",
           [] {
             return speckled({48, 40}, kRate2x1);
           }),
      hard("rate_2x1_odd_frame", "the other pixel of each pair",
           [] {
             return speckled({48, 40}, kRate2x1, 1);
           }),
      hard("all_2x2_even", "whole tiles without entries, and partial ones with",
           [] {
             return speckled({72, 56}, kRate2x2, 6);
           }),
      hard("all_2x2_odd", "the lower right pixels are the primaries",
           [] {
             return speckled({72, 56}, kRate2x2, 7);
           }),
      hard("odd_extent", "the last column and row have no partner",
           [] {
             return speckled({33, 49}, kRate2x2);
           }),
      hard("odd_extent_odd_frame", "nor has a lower right pixel",
           [] {
             return speckled({35, 51}, kRate2x2, 1);
           }),
      hard("checkerboard_of_rates", "neighbours are duplicates of another kind",
           [] {
             Picture p = speckled({64, 64}, kRate2x1);
             for (uint i = 0; i < p.rates.size(); ++i) p.rates[i] = (i + i / 32) % 2 ? kRate1x2 : kRate2x2;
             return p;
           }),
      hard("primaries_224", "the longest list that is stored", [] { return with_primaries(224); }),
      hard("primaries_225", "the shortest that is not: the whole tile was shaded", [] { return with_primaries(225); }),
      listed(
          "flagged_225", "a list that is too long is left alone, whatever its entries say",
          [] {
            return speckled({16, 16}, kRate2x2);
          },
          [](const Picture&, Lists& lists) {
            lists.tiles[0] = 225;
            for (uint i = 0; i < kVrcsTileEntries; ++i) lists.entries[i] = i | kCopyBits << 8;
          }),
      listed(
          "fogged", "tiles with fog are deblocked as others are, all 2x2 or not",
          [] {
            return speckled({64, 40}, kRate2x2);
          },
          [](const Picture&, Lists& lists) {
            for (uint& word : lists.tiles) word |= kVrcsTileFog;
          }),
      listed(
          "last_entry", "the list's last entry counts, what lies behind it does not",
          [] {
            return speckled({16, 16}, kRate1x1);
          },
          [](const Picture&, Lists& lists) {
            lists.tiles[0] = 33;
            for (uint i = 0; i < kVrcsTileEntries; ++i) lists.entries[i] = i | (i >= 32 ? kCopyHorizontal << 8 : 0);
          }),
  };
}

std::vector<HardCase> hostile_cases() {
  return {
      listed(
          "every_word", "every combination of a tile's flags and counts up to 511",
          [] {
            return speckled({512, 16 * 16}, kRate2x1);
          },
          [](const Picture&, Lists& lists) {
            for (uint t = 0; t < lists.tiles.size(); ++t) lists.tiles[t] = (t % 16) << 9 | (t * 41 % 512);
          }),
      listed(
          "random_entries", "entries of any bits: pixels named twice, primaries that are copied",
          [] {
            return speckled({96, 80}, kRate2x2);
          },
          [](const Picture&, Lists& lists) {
            Pcg32 rng(5);
            for (uint& word : lists.tiles) word = rng.below(225);
            for (uint& entry : lists.entries) entry = rng.next();
          }),
      listed(
          "entries_off_screen", "a partial tile's entries beyond the last column, which copy onto the screen",
          [] {
            return speckled({21, 19}, kRate1x1);
          },
          [](const Picture&, Lists& lists) {
            for (uint& word : lists.tiles) word = 128;
            for (uint i = 0; i < lists.entries.size(); ++i)
              lists.entries[i] = (2 * (i % 224) + 1) % 256 | kCopyBits << 8;
          }),
      listed(
          "all_2x2_of_part", "a partial tile that says it is all 2x2",
          [] {
            return speckled({21, 19}, kRate1x1, 1);
          },
          [](const Picture&, Lists& lists) {
            for (uint& word : lists.tiles) word = kVrcsTile2x2 | 64;
          }),
      listed(
          "all_flags", "sky and 1x1 go before 2x2",
          [] {
            return speckled({64, 64}, kRate2x2);
          },
          [](const Picture&, Lists& lists) {
            for (uint t = 0; t < lists.tiles.size(); ++t)
              lists.tiles[t] |= kVrcsTile2x2 | (t % 2 ? kVrcsTileSky : kVrcsTile1x1);
          }),
      listed(
          "everything_copies", "a row of duplicates only: each may be read old or new",
          [] {
            return speckled({64, 64}, kRate1x1);
          },
          [](const Picture&, Lists& lists) {
            for (uint& word : lists.tiles) word = 16;
            for (uint i = 0; i < lists.entries.size(); ++i) lists.entries[i] = i % 16 * 16 | kCopyBits << 8;
          }),
  };
}

// Something in one place of every eighth pixel along both axes.
Picture dotted(double value, size_t channel, uint rate) {
  Picture p = speckled({64, 64}, rate);
  for (uint y = 0; y < 64; y += 8)
    for (uint x = y / 8 % 2 * 4; x < 64; x += 8) p.texels[p.place(x, y)][channel] = half_bits(value);
  return p;
}

std::vector<HardCase> value_cases() {
  return {
      hard("nan_neighbours", "a pair with a NaN does not count; a copy of one stays",
           [] { return dotted(kNaN, 0, kRate2x2); }),
      hard("infinite_neighbours", "nor one with an infinity", [] { return dotted(-kInfinity, 2, kRate2x2); }),
      hard("nan_alpha", "alpha is not averaged, and may be anything", [] { return dotted(kNaN, 3, kRate2x1); }),
      hard("alpha_differs", "alpha stays the pixel's own beside a background of 0",
           [] { return dotted(0, 3, kRate2x1); }),
      hard("largest", "the sum of two halves is none, their mean is",
           [] {
             return at_rate(painted({32, 32}, [](uint x, uint) { return grey(x % 4 ? 65504 : 65472); }), kRate2x2);
           }),
      hard("ties", "means half-way between two halves go to the even one",
           [] {
             return at_rate(
                 painted({32, 32},
                         [](uint x, uint y) {
                           const auto h = static_cast<uint16_t>(0x3c00 + x / 2 * 3 + y);
                           return Texel{h, static_cast<uint16_t>(h ^ 0x8000), static_cast<uint16_t>(h + 1), 0};
                         }),
                 kRate2x1);
           }),
      hard("sum_rounded", "the largest half and the least: their sum is no float",
           [] {
             return at_rate(painted({32, 32}, [](uint x, uint y) { return grey((x / 2 + y) % 2 ? 65504 : 0x1p-24); }),
                            kRate2x2);
           }),
      hard("subnormal", "halves below 2^-14 and their means",
           [] {
             return at_rate(painted({32, 32},
                                    [](uint x, uint y) {
                                      const auto h = static_cast<uint16_t>((x * 37 + y * 101) % 1100);
                                      return Texel{h, static_cast<uint16_t>(h | 0x8000), 1, 0x3c00};
                                    }),
                            kRate2x2);
           }),
      hard("signs", "means of what cancels are +0",
           [] {
             return at_rate(painted({32, 32}, [](uint x, uint y) { return grey((x / 2 + y / 2) % 2 ? -0.75 : 0.75); }),
                            kRate2x2);
           }),
      hard("every_half", "all 65,536 halves in every channel, not changed, and their luma",
           [] {
             return painted({256, 256}, [](uint x, uint y) {
               const auto h = static_cast<uint16_t>(y * 256 + x);
               return Texel{h, static_cast<uint16_t>(h ^ 0x8000), static_cast<uint16_t>(h + 77), h};
             });
           }),
      hard("every_half_averaged", "and their means",
           [] {
             return at_rate(
                 painted({256, 256},
                         [](uint x, uint y) {
                           const auto h = static_cast<uint16_t>(y * 256 + x);
                           return Texel{h, static_cast<uint16_t>(h * 257), static_cast<uint16_t>(h * 4099), h};
                         }),
                 kRate2x2);
           }),
      hard("channels_apart", "luma's weights cannot be swapped",
           [] {
             return painted({48, 16}, [](uint x, uint) {
               Texel t = grey(0);
               t[x / 16] = nearest_half(0.3);
               return t;
             });
           }),
      hard("dark_exposure", "luma of the exposed radiance",
           [] {
             Picture p = speckled({40, 40}, kRate2x1);
             p.exposure = 0.02f;
             return p;
           }),
      hard("no_exposure", "an exposure that is no number: luma 0",
           [] {
             Picture p = speckled({40, 40}, kRate2x1);
             p.exposure = std::numeric_limits<float>::quiet_NaN();
             return p;
           }),
  };
}

// Left of `edge` one surface, right of it another, of other brightness.
Picture edge_at(uint edge, uint rate) {
  Picture p = at_rate(painted({64, 48}, [=](uint x, uint) { return grey(x < edge ? 0.25 : 4); }), rate);
  for (uint y = 0; y < 48; ++y)
    for (uint x = edge; x < 64; ++x) p.visibility[p.place(x, y)] = uvec2(9, 4), p.depth[p.place(x, y)] = 0.05f;
  return p;
}

std::vector<HardCase> guard_cases() {
  return {
      hard("step_on_tile_border", "a silhouette where two tiles meet: unguarded, the step spills",
           [] { return edge_at(32, kRate2x2); }),
      hard("step_within_cells", "a silhouette through cells", [] { return edge_at(27, kRate2x2); }),
      hard("same_depth", "two surfaces side by side at one depth",
           [] {
             Picture p = edge_at(32, kRate2x1);
             p.depth.assign(p.depth.size(), 0.02f);
             return p;
           }),
      hard("fold", "one surface in front of itself, then behind",
           [] {
             Picture p = edge_at(32, kRate2x1);
             p.visibility.assign(p.visibility.size(), uvec2(7, 3));
             for (uint y = 24; y < 48; ++y)
               for (uint x = 32; x < 64; ++x) p.depth[p.place(x, y)] = 0.001f;
             return p;
           }),
      hard("depth_at_the_limit", "depths as far apart as is close, and one float farther",
           [] {
             Picture p = speckled({64, 64}, kRate2x1);
             for (uint y = 0; y < 64; ++y)
               for (uint x = 0; x < 64; ++x) {
                 const uint apart = (x / 2 % 2) * (kCloseDepths + y % 2);
                 p.depth[p.place(x, y)] = std::bit_cast<float>(0x3c000000u + apart);
               }
             return p;
           }),
      hard("odd_depths", "NaN, negative, infinite and denormal depths",
           [] {
             Picture p = speckled({64, 64}, kRate2x2);
             constexpr float kOdd[] = {NAN, -NAN, INFINITY, -0.0f, 0, -1, 1e-40f, 0.01f};
             for (uint i = 0; i < p.depth.size(); ++i) p.depth[i] = kOdd[(i * 7 + i / 64 * 3) % 8];
             return p;
           }),
      hard("triangles", "edges of triangles within one surface, 2x2 between",
           [] {
             Picture p = speckled({80, 64}, kRate2x2);
             for (uint i = 0; i < p.visibility.size(); ++i) p.visibility[i].x = i % 80 / 10 + i / 80 / 10 * 8;
             return p;
           }),
      hard("same_triangle_index", "triangles of two surfaces that have one index",
           [] {
             Picture p = edge_at(32, kRate2x1);
             for (uvec2& v : p.visibility) v.x = 7;
             return p;
           }),
      hard("flipped_bits", "the bits above a surface's index are not of it",
           [] {
             Picture p = speckled({48, 48}, kRate2x1);
             for (uint i = 0; i < p.visibility.size(); ++i)
               p.visibility[i].y |= (i / 2 % 2 ? kVisibilityFlipped : 0) | (i / 4 % 2 ? kVisibilityInstanced : 0);
             return p;
           }),
      hard("all_sky", "nothing but the background",
           [] {
             Picture p = speckled({40, 40}, kRate2x2);
             p.visibility.assign(p.visibility.size(), uvec2(kVisibilityNone, kVisibilityNone));
             return p;
           }),
      hard("one_pixel_of_sky", "an uncovered pixel is in no list, and neighbours take it in",
           [] {
             Picture p = speckled({32, 32}, kRate2x2);
             p.visibility[p.place(12, 12)] = uvec2(kVisibilityNone, kVisibilityNone);
             return p;
           }),
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases;
  for (const Extent e : {Extent{1, 1}, {2, 2}, {1, 300}, {300, 1}, {15, 17}, {16, 16}, {17, 15}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return case_of(speckled(e, kRate2x2)); }});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = list_cases();
  for (auto& more : {hostile_cases(), value_cases(), guard_cases(), sizes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {{"nearest_halves.glsl", 1, "means are truncated", "rate_1x2"},
          {"nearest_halves.glsl", 2, "red and green swapped", "rate_1x2"},
          {"duplicates.glsl", 3, "the last column is not on the screen", "odd_extent"},
          {"duplicates.glsl", 4, "the upper left in every frame", "all_2x2_odd"},
          {"duplicates.glsl", 5, "the diagonal duplicate is forgotten", "all_2x2_even"},
          {"duplicates.glsl", 6, "224 entries are too many", "primaries_224"},
          {"duplicates.glsl", 7, "fogged tiles are left alone", "fogged"},
          {"duplicates.glsl", 8, "an entry too many", "last_entry"},
          {"duplicates.glsl", 9, "the barrier after the marks dropped", "rate_1x2"},
          {"deblock.glsl", 10, "NaN spreads", "nan_neighbours"},
          {"deblock.glsl", 11, "one diagonal of two", "all_2x2_even"},
          {"harness/glsl/luma.glsl", 9731, "luma's red and blue swapped", "channels_apart"},
          {"deblock.glsl", 13, "the copy's luma", "rate_1x2"},
          {"guarded.comp", 14, "surfaces are not asked for", "same_depth"},
          {"guarded.comp", 15, "the farther neighbour is close", "fold"},
          {"guarded_by_triangle.comp", 16, "triangles of all surfaces alike", "same_triangle_index"},
          {"in_place.comp", 17, "nothing is stored", "rate_1x2"},
          {"luma_alone.comp", 18, "the last column has none", "all_1x1"},
          {"half_codes.comp", 20, "halves by columns", "all_1x1"},
          {"harness/glsl/tone_curve.glsl", 9701, "a bucket's first code for all of it", "all_1x1"},
          {"harness/glsl/tone_curve.glsl", 9702, "what is past the last bucket is black", "all_1x1"}};
}

}  // namespace assay::vrcs_deblock
