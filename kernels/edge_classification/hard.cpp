// Named hard cases, and the faults that they must find.
#include "kernels/edge_classification/inputs.h"

namespace assay::edge_classification {

namespace {

uint pack(int32_t x, int32_t y) { return static_cast<uint16_t>(x) | uint{static_cast<uint16_t>(y)} << 16; }

// 4 samples a pixel, both tests, threshold 100; `change` edits the samples.
template <class F>
Case with(Extent e, F change) {
  Samples s({e.width, e.height, 4, 1, 100, 0});
  change(s);
  return s.to_case();
}

// One pixel of the middle tile of nine whose last sample has another material.
Case dot(uint32_t x, uint32_t y) {
  return with({24, 24}, [=](Samples& s) { s.materials[s.place(8 + x, 8 + y, 3)] = 8; });
}

// Two samples in one pixel whose gradients differ.
Case pair(uint threshold, uint a, uint b) {
  return with({9, 9}, [=](Samples& s) {
    s.params.threshold = threshold;
    s.gradients.assign(s.gradients.size(), a);
    s.gradients[s.place(4, 5, 2)] = b;
  });
}

// One sample a pixel, compared with its neighbours.
template <class F>
Case neighbours(Extent e, F change) {
  Samples s({e.width, e.height, 1, 1, 100, 1});
  change(s);
  return s.to_case();
}

// A column of one-pixel-wide tiles; every `stride`-th has an edge (0: none).
Case column(uint32_t tiles, uint32_t stride) {
  Samples s({1, tiles * kEdgeTileSide, 2, 0, 0, 0});
  for (uint32_t tile = 0; stride && tile < tiles; tile += stride) s.materials[s.place(0, tile * 8 + tile % 8, 1)] = 8;
  return s.to_case();
}

Case with_samples(uint samples) {
  Samples s({17, 9, samples, 1, 100, 1});
  s.materials[s.place(3, 3)] = 8;
  s.gradients[s.place(16, 8, 0)] = pack(101, 0);
  return s.to_case();
}

std::vector<HardCase> places() {
  return {
      {"corner_top_left", "one edge pixel: bit 0 of the middle tile and of no other", [] { return dot(0, 0); }},
      {"corner_top_right", "the last of a row: bit 7", [] { return dot(7, 0); }},
      {"corner_bottom_left", "the first of the last row: bit 56", [] { return dot(0, 7); }},
      {"corner_bottom_right", "bit 63, in the last lane of the last subgroup", [] { return dot(7, 7); }},
      {"end_of_first_word", "bit 31", [] { return dot(7, 3); }},
      {"start_of_second_word", "bit 32", [] { return dot(0, 4); }},
      {"edges_in_every_other_tile", "neighbouring tiles of one group differ; each tile has another pixel",
       [] {
         return with({72, 40}, [](Samples& s) {
           for (uint32_t t = 0; t < 45; t += 2) s.materials[s.place(t % 9 * 8 + t % 8, t / 9 * 8 + t % 5, 1)] = 8;
         });
       }},
      {"every_pixel", "all 64 bits of whole and partial tiles: one list is empty",
       [] {
         return with({21, 13}, [](Samples& s) {
           for (size_t i = 0; i < s.materials.size(); i += 4) s.materials[i] = 1;
         });
       }},
      {"no_pixel", "no edge: the other list is empty",
       [] {
         return with({21, 13}, [](Samples&) {});
       }},
  };
}

std::vector<HardCase> comparisons() {
  return {
      {"threshold_met", "a difference of the threshold itself is no edge",
       [] { return pair(100, pack(-50, 3), pack(50, 3)); }},
      {"threshold_passed", "one more is", [] { return pair(100, pack(-50, 3), pack(51, 3)); }},
      {"second_component", "only the other component differs", [] { return pair(100, pack(9, -70), pack(9, 70)); }},
      {"sign_change", "1 and -1 are two units apart, not 65,534", [] { return pair(2, pack(-1, 1), pack(1, -1)); }},
      {"minus_one_twice", "-32768 and -32767 both mean -1",
       [] { return pair(0, pack(-32768, -32767), pack(-32767, -32768)); }},
      {"widest_difference", "-1 to 1 is 65,534 units, more than 16 bits hold with sign",
       [] { return pair(65533, pack(-32768, 0), pack(32767, 0)); }},
      {"threshold_beyond_all", "a threshold of 65,534 lets no gradient be an edge",
       [] { return pair(65534, pack(-32767, -32767), pack(32767, 32767)); }},
      {"threshold_all_ones", "2^32 - 1, negative were it signed", [] { return pair(0xffffffffu, 0, pack(32767, 0)); }},
      {"materials_alone", "gradients differ and are not asked",
       [] {
         return with({9, 9}, [](Samples& s) { s.params.gradients = 0, s.materials[s.place(2, 2, 1)] = 8; });
       }},
      {"material_of_high_bit", "materials that differ in bit 31 only",
       [] {
         return with({9, 9}, [](Samples& s) { s.materials[s.place(2, 2, 3)] ^= 1u << 31; });
       }},
      {"drift", "each sample is within the threshold of the next but not of the first",
       [] {
         return with({8, 8}, [](Samples& s) {
           for (int32_t i = 0; i < 4; ++i) s.gradients[s.place(1, 6, static_cast<uint32_t>(i))] = pack(60 * i, 0);
         });
       }},
  };
}

std::vector<HardCase> neighbour_cases() {
  return {
      {"screen_edges", "the last column and row have no neighbour; the next row's first pixel is none",
       [] {
         return neighbours({16, 16}, [](Samples& s) {
           for (uint32_t y = 0; y < 16; ++y) s.materials[s.place(0, y)] = 1;
         });
       }},
      {"neighbour_tiles", "the neighbour lies in the next tile",
       [] {
         return neighbours(
             {24, 24}, [](Samples& s) { s.materials[s.place(8, 4)] = 1, s.gradients[s.place(4, 16)] = pack(0, 101); });
       }},
      {"one_sample", "one sample a pixel and no neighbours asked: no edges however the screen looks",
       [] {
         return neighbours({24, 24}, [](Samples& s) {
           s.params.neighbours = 0;
           for (size_t i = 0; i < s.materials.size(); ++i) s.materials[i] = static_cast<uint>(i);
         });
       }},
      {"samples_0", "zero samples a pixel count as one", [] { return with_samples(0); }},
      {"samples_3", "a number that is no power of two", [] { return with_samples(3); }},
      {"samples_8", "the most", [] { return with_samples(8); }},
      {"samples_9", "one too many counts as eight", [] { return with_samples(9); }},
      {"samples_all_ones", "2^32 - 1 samples count as eight", [] { return with_samples(0xffffffffu); }},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases = {
      {"tiles_300", "more tiles than an appending group has threads, on both lists", [] { return column(300, 3); }},
      {"tiles_33", "one tile more than a group of mark_subgroup takes", [] { return column(33, 1); }},
      {"edges_65535", "the last list that one dimension of a dispatch holds", [] { return column(65535, 1); }},
      {"edges_65536", "the first that needs another", [] { return column(65536, 1); }},
      {"plain_65537", "two rows that cannot be equal: one group is left over", [] { return column(65537, 0); }},
      {"mixed_131072", "both lists at 65,536", [] { return column(131072, 2); }},
      {"no_pixels", "an empty screen has no tile at all",
       [] {
         return with({0, 0}, [](Samples&) {});
       }},
  };
  for (const Extent e : {Extent{1, 1}, {7, 9}, {8, 8}, {9, 7}, {31, 33}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  cases.push_back({"size_3840x2160", "129,600 tiles, the frame's largest view",
                   [] {
                     return typical({3840, 2160});
                   },
                   true});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = places();
  for (auto& more : {comparisons(), neighbour_cases(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "gradients lose their sign", "sign_change"},
      {"common.glsl", 2, "the threshold itself is an edge", "threshold_met"},
      {"common.glsl", 3, "the second component is forgotten", "second_component"},
      {"common.glsl", 4, "the last sample is not looked at", "corner_top_left"},
      {"common.glsl", 5, "the last column's neighbour is the next row's first", "screen_edges"},
      {"mark_shared.comp", 6, "the atomic is lost", "every_pixel"},
      {"mark_shared.comp", 7, "the barrier before the store is dropped", "corner_bottom_right"},
      {"mark_ballot.comp", 8, "the barrier before the votes are joined is dropped", "tiles_33"},
      {"mark_ballot.comp", 9, "both tiles of a group get the first one's votes", "edges_in_every_other_tile"},
      {"mark_subgroup.comp", 10, "the lower half of the tile is left out", "start_of_second_word"},
      {"mark_subgroup.comp", 11, "the lower half's votes land on the upper half's bits", "start_of_second_word"},
      {"append.comp", 12, "the atomic of the group's count is lost", "tiles_300"},
      {"append.comp", 13, "the barrier before the reservation is dropped", "tiles_300"},
      {"args.comp", 14, "tiles beyond 65,535 are lost", "edges_65536"},
  };
}

}  // namespace assay::edge_classification
