// Named hard cases, and the faults that they must find.
#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/vrcs_coordinates/inputs.h"

namespace assay::vrcs_coordinates {

namespace {

using vrcs::drawn, vrcs::of_one, vrcs::Pictured;

Case in_frame_number(const Pictured& s, uint frame) {
  return with_params(case_of(s), [=](VrcsParams& p) { p.frame = frame; });
}

// Tiles of so many primaries: cells of four, of two and of one.
Case primaries(uint count) {
  const uint fours = (count - 64) / 3, twos = (count - 64) % 3;
  Pictured s = of_one({48, 32}, kRate2x2);
  for (uint y = 0; y < 16; ++y)
    for (uint x = 0; x < 24; ++x) {
      const uint i = y % 8 * 8 + x % 8;
      if (i < fours + twos) s.rates[y * 24 + x] = i < fours ? kRate1x1 : kRate2x1;
    }
  return case_of(s);
}

// The partition of four pixels: the number of each one's part, parts numbered by their first pixels.
std::vector<std::array<uint, 4>> partitions() {
  std::vector<std::array<uint, 4>> all;
  for (uint i = 0; i < 256; ++i) {
    const std::array<uint, 4> part = {i % 4, i / 4 % 4, i / 16 % 4, i / 64};
    uint next = 0;
    const bool in_order = std::ranges::all_of(part, [&](uint p) { return p <= next && (next += p == next, true); });
    if (in_order) all.push_back(part);
  }
  return all;
}

// Every partition by triangle, of every set of covered pixels, at every rate: a cell each, holes of 0xffff by it.
Case every_partition(uint frame) {
  const auto all = partitions();  // 15 of them
  constexpr uint8_t kRates[] = {kRate1x1, kRate1x2, kRate2x1, kRate2x2};
  Pictured s = vrcs::empty_screen({120, 32});
  for (uint y = 0; y < 16; ++y)
    for (uint x = 0; x < 60; ++x) {
      s.rates[y * 60 + x] = kRates[x % 4];
      for (uint i = 0; i < 4; ++i)
        if (y >> i & 1) s.cover(x * 2 + i % 2, y * 2 + i / 2, {100 + all[x / 4][i], 1});
    }
  return in_frame_number(s, frame);
}

uvec2 checkered(uint x, uint y) { return {(x + y) % 2, 1}; }

std::vector<HardCase> covers() {
  return {
      {"all_sky", "no primary: nothing but words and copy bits",
       [] {
         return case_of(vrcs::empty_screen({48, 40}));
       }},
      {"one_pixel_of_sky", "one tile of four is no longer all 2x2, and its cell has three pixels",
       [] {
         Pictured s = of_one({32, 32}, kRate2x2);
         s.visibility[s.place(21, 18)] = uvec2(kVisibilityNone);
         return case_of(s);
       }},
      {"one_pixel_covered", "the last pixel of the last cell of a tile",
       [] {
         Pictured s = vrcs::empty_screen({48, 48});
         s.cover(31, 31, {0, 0});
         return case_of(s);
       }},
      {"own_triangles", "every pixel its own: 256 primaries, more than the list's room",
       [] {
         return case_of(drawn({40, 40}, kRate2x2, [](uint x, uint y) { return uvec2(y * 40 + x, 1); }));
       }},
      {"checkerboard", "only diagonals share: two primaries a cell",
       [] {
         return case_of(drawn({64, 48}, kRate2x2, checkered));
       }},
      {"checkerboard_odd_frame", "and the others of the two",
       [] {
         return in_frame_number(drawn({64, 48}, kRate2x2, checkered), 1);
       }},
      {"primaries_224", "the most that are stored", [] { return primaries(224); }},
      {"primaries_225", "the least that are not", [] { return primaries(225); }},
      {"one_a_cell", "64 primaries, and not all 2x2",
       [] {
         return case_of(drawn({32, 32}, kRate2x2,
                              [](uint x, uint y) { return x % 2 && y % 2 ? uvec2(1, 1) : uvec2(kVisibilityNone); }));
       }},
      {"surfaces_apart", "the same triangle of two surfaces, one far behind the other",
       [] {
         Pictured s = drawn({32, 32}, kRate2x2, [](uint x, uint) { return uvec2(5, x % 2); });
         for (size_t n = 0; n < s.depth.size(); ++n) s.depth[n] = n % 2 ? 0.1f : 0.01f;
         return case_of(s);
       }},
      {"triangle_all_ones", "a triangle, or a surface, of all ones is a surface yet",
       [] {
         return case_of(drawn({32, 32}, kRate2x2, [](uint x, uint) {
           return x % 3 ? uvec2(kVisibilityNone, 1) : uvec2(1, kVisibilityNone);
         }));
       }},
  };
}

std::vector<HardCase> rates() {
  std::vector<HardCase> cases = {
      {"unknown_rates", "every byte: all but four mean 1x1",
       [] {
         Pictured s = of_one({64, 16}, 0);
         for (size_t i = 0; i < s.rates.size(); ++i) s.rates[i] = static_cast<uint8_t>(i);
         return case_of(s);
       }},
      {"new_view", "frame 0, a cut, another resolution: the rates are another view's",
       [] {
         return with_params(case_of(of_one({32, 32}, kRate2x2)), [](VrcsParams& p) { p.all_1x1 = 1; });
       }},
      {"last_frame_number", "2^32 - 1: the third step of three, and odd",
       [] { return with_params(every_partition(0), [](VrcsParams& p) { p.frame = 0xffffffffu; }); }},
  };
  const std::pair<const char*, uint8_t> kAll[] = {
      {"rate_1x1", kRate1x1}, {"rate_1x2", kRate1x2}, {"rate_2x1", kRate2x1}, {"rate_2x2", kRate2x2}};
  for (const auto& [name, rate] : kAll)
    cases.push_back({name, "one rate and triangle, with cells cut at both sides", [rate = rate] {
                       return case_of(of_one({37, 35}, rate));
                     }});
  for (uint frame = 0; frame < 4; ++frame)
    cases.push_back({"partitions_frame_" + std::to_string(frame),
                     "all 15 partitions of a cell by triangle, all 16 covers, all rates",
                     [frame] { return every_partition(frame); }});
  return cases;
}

std::vector<HardCase> depths() {
  return {
      {"fog_edge", "a tile at the depth where fog begins, and one with a pixel beyond",
       [] {
         Pictured s = of_one({32, 16}, kRate2x2);
         s.depth[s.place(20, 7)] = std::nextafter(0.01f, 0.0f);
         return with_params(case_of(s), [](VrcsParams& p) { p.fog_depth = 0.01f; });
       }},
      {"fog_not_a_number", "no fog, though its bits are above all depths'",
       [] {
         return with_params(case_of(of_one({32, 16}, kRate2x2)), [](VrcsParams& p) { p.fog_depth = NAN; });
       }},
      {"fog_negative", "no fog, likewise",
       [] {
         return with_params(case_of(of_one({32, 16}, kRate2x2)), [](VrcsParams& p) { p.fog_depth = -1; });
       }},
      {"odd_depths", "NaN, infinities, zero, negative and denormal: as far as can be, and close to none",
       [] {
         Pictured s = drawn({32, 16}, kRate2x2, [](uint x, uint) { return uvec2(x, 1); });
         constexpr float kOdd[] = {NAN, INFINITY, -INFINITY, 0, -0.0f, -0.5f, 1e-40f, 0x1p-126f, 3e38f};
         for (size_t i = 0; i < s.depth.size(); ++i) s.depth[i] = kOdd[i / 2 % 9];
         return with_params(case_of(s), [](VrcsParams& p) { p.fog_depth = 0x1p-126f; });
       }},
      {"depth_range", "from beyond the near plane to beyond the far one",
       [] {
         Pictured s = of_one({64, 64}, kRate1x2);
         for (size_t i = 0; i < s.depth.size(); ++i) s.depth[i] = std::exp2(2 - static_cast<float>(i) / 200);
         return case_of(s);
       }},
      {"close_depths_edge", "depths that differ by just 2^-6, by one place more, across a power of two",
       [] {
         // Triangles of two columns, flat, so that a normal can be rebuilt; cells lie across their seams.
         Pictured s = drawn({32, 16}, kRate2x1, [](uint x, uint) { return uvec2((x + 1) / 2, 1); });
         constexpr float kDepths[] = {1, 0x3fp-6f, 1, 0x1.f7fffep-1f, 1.5f, 1.4765625f, 1.5f, 1.4765624f};
         for (size_t i = 0; i < s.depth.size(); ++i) s.depth[i] = kDepths[(i % 32 + 1) / 2 % 8];
         return case_of(s);
       }},
  };
}

std::vector<HardCase> rules() {
  const auto own_columns = [](uint x, uint) { return uvec2(x, 1); };
  return {
      {"normals_opposed",
       "stored back to back, where the sine is 0; rebuilt at an obtuse angle, folds two columns wide",
       [] {
         Pictured s = drawn({32, 16}, kRate2x1, [](uint x, uint) { return uvec2((x + 1) / 2, 1); });
         for (size_t n = 0; n < s.depth.size(); ++n) {
           s.face_normals[n] = (n % 32 + 1) / 2 % 2 ? 0x7fff7fffu : 0;  // -z and +z
           s.depth[n] = (n % 32 + 2) / 2 % 2 ? 0.011f : 0.01f;
         }
         return with_params(case_of(s), [](VrcsParams& p) { p.close_normals_log2 = 0; });
       }},
      {"normals_folded", "corners of the octahedron's square are one direction; so are the two lowest codes",
       [=] {
         Pictured s = drawn({32, 16}, kRate2x1, own_columns);
         constexpr uint kCodes[] = {0x7fff7fffu, 0x80018001u, 0x80008000u, 0x80017fffu};
         for (size_t i = 0; i < s.face_normals.size(); ++i) s.face_normals[i] = kCodes[i % 4];
         return case_of(s);
       }},
      {"surface_flags", "one surface, flagged differently from pixel to pixel",
       [] {
         return case_of(drawn({32, 16}, kRate2x2, [](uint x, uint y) {
           return uvec2(x, 5 | x % 2 * kVisibilityFlipped | y % 2 * kVisibilityInstanced);
         }));
       }},
      {"lines", "triangles of a row: three pixels are in a line, and their depths on no plane",
       [] {
         Pictured s = drawn({32, 32}, kRate1x2, [](uint, uint y) { return uvec2(y, 1); });
         for (size_t i = 0; i < s.depth.size(); ++i) s.depth[i] += 1e-5f * static_cast<float>(i % 32 * (i % 32));
         return case_of(s);
       }},
      {"one_plane", "triangles of blocks of 3x3 on one plane: normals are rebuilt from threes of all orders",
       [] {
         Pictured s = drawn({64, 64}, kRate2x2, [](uint x, uint y) { return uvec2(y / 3 * 30 + x / 3, 1); });
         for (uint y = 0; y < 64; ++y)
           for (uint x = 0; x < 64; ++x)
             s.depth[s.place(x, y)] = 0.01f + 1e-4f * static_cast<float>(x) + 5e-5f * static_cast<float>(y);
         return case_of(s);
       }},
      {"steep", "slopes of half the depth a pixel, and more",
       [] {
         Pictured s = drawn({64, 64}, kRate2x2, [](uint x, uint y) { return uvec2(y / 4 * 30 + x / 2, 1); });
         for (uint y = 0; y < 64; ++y)
           for (uint x = 0; x < 64; ++x) s.depth[s.place(x, y)] = std::exp2(static_cast<float>(x + y / 3) / 3 - 20);
         return with_params(case_of(s), [](VrcsParams& p) {
           p.close_depths_log2 = 1, p.close_normals_log2 = 3, p.focal_x = 16383, p.focal_y = 20000;
         });
       }},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases;
  for (const Extent e :
       {Extent{1, 1}, {2, 1}, {1, 2}, {2, 2}, {15, 17}, {16, 16}, {17, 15}, {31, 33}, {1, 2049}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  cases.push_back({"size_3840x2160", "32,400 tiles, the frame's largest view", [] { return typical({3840, 2160}); }});
  cases.push_back({"size_16384x33", "the most pixels a side, 14 bits of an entry", [] {
                     return case_of(of_one({16384, 33}, kRate2x1));
                   }});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = covers();
  for (auto& more : {rates(), depths(), rules(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"cell.glsl", 1, "pixels beyond the last column or row count", "rate_2x1"},
      {"cell.glsl", 2, "a triangle of all ones is taken for nothing", "triangle_all_ones"},
      {"cell.glsl", 3, "the rates of another view are used", "new_view"},
      {"cell.glsl", 4, "what is coarser than any known rate is the coarsest", "unknown_rates"},
      {"cell.glsl", 5, "triangles are compared, whatever the surface", "surfaces_apart"},
      {"cell.glsl", 6, "three pixels: there, and from the first again", "partitions_frame_3"},
      {"cell.glsl", 7, "all pairs of a frame alike: no checkerboard", "primaries_224"},
      {"tile.glsl", 8, "the depth where fog begins is fogged", "fog_edge"},
      {"tile.glsl", 9, "as many primaries as cells pass for all 2x2", "one_a_cell"},
      {"tile.glsl", 10, "20 bits of depth", "one_pixel_of_sky"},
      {"tile.glsl", 11, "a list that just saves a wave is not stored", "primaries_224"},
      {"tile.glsl", 12, "the screen's list lacks what no tile's list holds", "own_triangles"},
      {"tile.glsl", 13, "a barrier dropped: cells of higher subgroups are missing", "one_pixel_of_sky"},
      {"depths.glsl", 14, "depths just 2^-n apart are not close", "close_depths_edge"},
      {"normals.glsl", 15, "back to back is as good as side by side", "normals_opposed"},
      {"same_surface.glsl", 16, "the surface's flags tell surfaces apart", "surface_flags"},
      {"stored_normal.glsl", 17, "the octahedron's lower half stays folded", "normals_folded"},
      {"rebuilt_normal.glsl", 18, "the order of the three turns the normal over", "one_plane"},
      {"rebuilt_normal.glsl", 19, "three in a line make a normal", "lines"},
      {"list_args.comp", 20, "the list's last group, not full, is not dispatched", "one_pixel_covered"},
  };
}

}  // namespace assay::vrcs_coordinates
