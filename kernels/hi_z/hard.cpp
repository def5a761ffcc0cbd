// Named hard cases, and the faults that they must find.
#include <cmath>
#include <limits>

#include "kernels/hi_z/inputs.h"

namespace assay::hi_z {

namespace {

// Every pixel another depth, ascending in scan order: each texel's ends are pixels of their own.
Case ascending(Extent e) {
  std::vector<float> depth(pixel_count(e));
  for (size_t i = 0; i < depth.size(); ++i) depth[i] = static_cast<float>(i + 1) / static_cast<float>(depth.size());
  return case_of(e, depth);
}

// One depth but for one pixel.
Case dot(Extent e, uint32_t x, uint32_t y, float value) {
  std::vector<float> depth(pixel_count(e), 0.25f);
  depth[size_t{y} * e.width + x] = value;
  return case_of(e, depth);
}

Case of_values(std::initializer_list<float> values) {
  std::vector<float> depth(size_t{64} * 64, 0.25f);
  size_t i = 0;
  for (const float v : values) depth[i * 4 * 65] = v, ++i;  // in texels of their own up to level 2
  return case_of({64, 64}, depth);
}

std::vector<HardCase> places() {
  return {
      {"last_pixel_nearest", "one pixel in the corner that odd sides leave over, at every level",
       [] {
         return dot({33, 65}, 32, 64, 1);
       }},
      {"last_pixel_farthest", "and the background there",
       [] {
         return dot({33, 65}, 32, 64, 0);
       }},
      {"first_pixel", "the other corner",
       [] {
         return dot({65, 33}, 0, 0, 1);
       }},
      {"end_of_a_tile", "the last lane of the last subgroup of a tile",
       [] {
         return dot({96, 96}, 63, 63, 1);
       }},
      {"start_of_a_tile", "the first pixel of the next",
       [] {
         return dot({96, 96}, 64, 64, 0);
       }},
      {"row_after_row", "a row's end and the next one's start lie side by side in memory",
       [] {
         std::vector<float> depth(size_t{5} * 7, 0.5f);
         for (size_t y = 0; y < 7; ++y) depth[y * 5] = y % 2 ? 1.0f : 0.125f;
         return case_of({5, 7}, depth);
       }},
      {"all_background", "depth 0 everywhere",
       [] {
         return case_of({70, 40}, std::vector<float>(size_t{70} * 40));
       }},
      {"all_nearest", "depth 1 everywhere: what is beyond the edges must not count as background",
       [] {
         return case_of({70, 41}, std::vector<float>(size_t{70} * 41, 1.0f));
       }},
  };
}

std::vector<HardCase> values() {
  return {
      {"not_numbers", "NaN of either sign is no surface: depth 0",
       [] {
         return of_values({NAN, -NAN});
       }},
      {"infinite", "nearer than every number; its negative is no surface",
       [] {
         return of_values({INFINITY, -INFINITY});
       }},
      {"denormal", "kept as they are, the least above 0",
       [] {
         return of_values({1e-40f, std::numeric_limits<float>::denorm_min()});
       }},
      {"all_denormal", "an order that a device which flushes them does not see",
       [] {
         std::vector<float> depth(size_t{33} * 31);
         for (size_t i = 0; i < depth.size(); ++i) depth[i] = static_cast<float>(i) * 0x1p-149f;
         return case_of({33, 31}, depth);
       }},
      {"negative", "below 0 and -0: no surface",
       [] {
         return of_values({-0.0f, -0.5f, -1e-40f});
       }},
      {"above_one", "no depth of a view, and kept",
       [] {
         return of_values({1.5f, 3e38f});
       }},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases;
  for (const Extent e :
       {Extent{1, 1}, {2, 2}, {3, 3}, {31, 33}, {32, 32}, {33, 31}, {1, 4096}, {4096, 1}, {1023, 1025}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return ascending(e); }});
  cases.push_back({"size_3840x2160", "12 levels, the frame's largest view", [] { return typical({3840, 2160}); }});
  cases.push_back({"size_16384x9", "14 levels, the most", [] { return ascending({16384, 9}); }});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = places();
  for (auto& more : {values(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "what an odd side leaves over is dropped", "last_pixel_nearest"},
      {"common.glsl", 2, "the farthest for the nearest", "first_pixel"},
      {"common.glsl", 3, "NaN passes", "not_numbers"},
      {"common.glsl", 4, "beyond a row's end, the next row", "last_pixel_nearest"},
      {"common.glsl", 5, "the fourth of four is forgotten", "end_of_a_tile"},
      {"tile.glsl", 6, "the barrier before shared memory is read is dropped", "end_of_a_tile"},
      {"tile.glsl", 7, "three of four in shared memory", "end_of_a_tile"},
      {"tile_subgroup.glsl", 8, "the lower two of four lanes are left out", "end_of_a_tile"},
      {"tile_subgroup.glsl", 9, "a lane's texel where its subgroup's should be", "size_1921x1081"},
      {"last_group.comp", 10, "a group does not count itself, none is the last", "size_1921x1081"},
      {"last_group.comp", 11, "the last level is left out", "size_1921x1081"},
  };
}

}  // namespace assay::hi_z
