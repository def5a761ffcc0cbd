// Named hard cases, and the faults that they must find.
#include "kernels/tile_classification/inputs.h"

namespace assay::tile_classification {

namespace {

struct Pixel {
  uint32_t x, y;
  uint bits;
};

Case dotted(Extent e, std::initializer_list<Pixel> pixels) {
  std::vector<uint> features(pixel_count(e));
  for (const Pixel& p : pixels) features[size_t{p.y} * e.width + p.x] |= p.bits;
  return with_table(case_of(e, features), {{0, 0, 0, 0}}, 1);
}

template <class F>
Case drawn(Extent e, F bits_at) {
  std::vector<uint> features;
  features.reserve(pixel_count(e));
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) features.push_back(bits_at(x, y));
  return case_of(e, features);
}

// One non-empty pixel a tile, in a column of one-pixel-wide tiles: many tiles for little memory.
Case column(uint32_t tiles, uint groups_per_tile = 32) {
  Case c = with_table(drawn({1, tiles * kTileSide}, [](uint32_t, uint32_t y) { return uint{y % kTileSide == 31}; }),
                      {{0, 0, 0, 0}, {1, 2, 0, 0}, {1, 0, 0, 0}}, 2);
  auto params = c.params<ClassifyParams>();
  params.groups_per_tile = groups_per_tile;
  c.set_params(params);
  return c;
}

// Three tiles by three whose tiles differ: 1, 2, 3, 4, ... as masks.
Case numbered_tiles() {
  return drawn({96, 96}, [](uint32_t x, uint32_t y) { return y / kTileSide * 3 + x / kTileSide + 1; });
}

Case numbered(const std::vector<Workload>& table, uint passes) { return with_table(numbered_tiles(), table, passes); }

template <class F>
Case changed(Case c, F change) {
  auto params = c.params<ClassifyParams>();
  change(params);
  c.set_params(params);
  return c;
}

std::vector<HardCase> placements() {
  return {
      {"corner_top_left", "one pixel, in a corner of the middle tile: a tile boundary off by one shows in a neighbour",
       [] {
         return dotted({96, 96}, {{32, 32, 1}});
       }},
      {"corner_top_right", "the same, opposite side",
       [] {
         return dotted({96, 96}, {{63, 32, 1}});
       }},
      {"corner_bottom_left", "the same, last row",
       [] {
         return dotted({96, 96}, {{32, 63, 1}});
       }},
      {"corner_bottom_right", "the last pixel of a tile, in the last lane of its last subgroup",
       [] {
         return dotted({96, 96}, {{63, 63, 1u << 31}});
       }},
      {"nothing", "no bit anywhere: every list is empty and every tile discarded",
       [] {
         return drawn({65, 65}, [](uint32_t, uint32_t) { return 0u; });
       }},
      {"every_bit", "all bits in all pixels: signed shifts and comparisons would show",
       [] {
         return drawn({65, 65}, [](uint32_t, uint32_t) { return kEveryFeature; });
       }},
      {"bits_apart",
       "each pixel of a tile's last row has a bit of its own: a lost update, or a lane that speaks for others, loses "
       "it",
       [] {
         return drawn({64, 64}, [](uint32_t x, uint32_t y) { return y % 32 == 31 ? 1u << x % 32 : 0; });
       }},
      {"high_lanes", "the tile's only bits are in its last pixels, written by the highest subgroups of the group",
       [] {
         return dotted({64, 32}, {{31, 31, 4}, {30, 31, 8}, {63, 31, 2}});
       }},
      {"partial_tiles", "columns and rows left over; the first pixel of a row has a bit that no other tile may see",
       [] {
         return drawn({33, 47}, [](uint32_t x, uint32_t y) { return x == 0 ? 1u << (y % 16) : 1u << 20; });
       }},
      {"straddling_subgroups", "101 pixels a row: at every width subgroups hold pixels of several tiles and rows",
       [] {
         return drawn({101, 70}, [](uint32_t x, uint32_t y) { return 1u << (x / 32 + y / 32 * 4); });
       }},
      {"one_column", "a subgroup in scan order holds pixels of as many tiles as it has lanes / 32, or of one",
       [] {
         return drawn({1, 1000}, [](uint32_t, uint32_t y) { return 1u << (y / 32); });
       }},
  };
}

std::vector<HardCase> tables() {
  return {
      {"excluded_pixel", "the pixel with the required bit also has the excluded one: the tile is not for that workload",
       [] {
         return with_table(dotted({64, 32}, {{5, 5, 3}, {40, 5, 1}}), {{0, 1, 2, 0}, {0, 0, 0, 1}}, 1);
       }},
      {"excluded_elsewhere", "required and excluded bits on different pixels of one tile",
       [] {
         return with_table(dotted({32, 32}, {{0, 0, 1}, {31, 31, 2}}), {{0, 1, 2, 0}, {0, 0, 0, 1}}, 1);
       }},
      {"required_in_part", "two bits required, tiles with one of them",
       [] {
         return numbered({{0, 3, 0, 0}, {0, 0, 0, 1}}, 1);
       }},
      {"overlapping_rows", "several rows match, the first must win",
       [] {
         return numbered({{0, 1, 0, 0}, {0, 3, 0, 1}, {0, 1, 0, 2}, {0, 0, 0, 3}}, 1);
       }},
      {"duplicate_rows", "the second of two equal rows stays empty",
       [] {
         return numbered({{0, 2, 0, 0}, {0, 2, 0, 0}, {0, 4, 0, 1}, {0, 4, 0, 1}}, 1);
       }},
      {"contradictory_rows", "bits both required and excluded never match, yet as the last row they are the default",
       [] {
         return numbered({{0, 1, 1, 0}, {0, kEveryFeature, kEveryFeature, 1}}, 1);
       }},
      {"passes_interleaved", "rows of three passes in no order: the default is the last of its own pass",
       [] {
         return numbered({{2, 1, 0, 0}, {0, 1, 0, 1}, {1, 8, 0, 2}, {0, 2, 0, 3}, {2, 4, 1, 4}, {1, 4, 8, 5}}, 3);
       }},
      {"irrelevant_tiles", "tiles that are not empty but have nothing for the pass",
       [] {
         return changed(numbered({{0, 1, 0, 0}, {0, 0, 0, 1}, {1, 0, 0, 2}}, 2),
                        [](ClassifyParams& p) { p.relevant[0] = 4, p.relevant[1] = 0; });
       }},
      {"pass_without_rows", "pass 1 has no row: all its groups are discarded",
       [] {
         return numbered({{0, 0, 0, 0}, {2, 1, 0, 0}}, 3);
       }},
      {"rows_of_unknown_passes", "rows whose pass is not run, or far out of range, take no tile",
       [] {
         return numbered({{0, 1, 0, 0}, {1, 0, 0, 0}, {7, 0, 0, 0}, {8, 0, 0, 0}, {0xffffffffu, 0, 0, 0}}, 1);
       }},
      {"no_workloads", "a table of no rows", [] { return numbered({}, 2); }},
      {"no_passes", "rows, but no pass",
       [] {
         return numbered({{0, 0, 0, 0}}, 0);
       }},
      {"full_table", "as many rows and passes as are allowed",
       [] {
         std::vector<Workload> table;
         for (uint w = 0; w < kMaxWorkloads; ++w) table.push_back({w % kMaxPasses, w / kMaxPasses + 1, 0, w});
         return numbered(table, kMaxPasses);
       }},
      {"too_many_workloads", "a count of 2^32 - 1 rows: the limit holds, nothing is read or written beyond",
       [] {
         return changed(numbered(std::vector<Workload>(kMaxWorkloads, {0, 0, 0, 0}), 1),
                        [](ClassifyParams& p) { p.workloads = 0xffffffffu; });
       }},
      {"too_many_passes", "a count of 2^32 - 1 passes",
       [] {
         return changed(numbered({{0, 1, 0, 0}, {7, 0, 0, 0}, {8, 0, 0, 0}}, 1),
                        [](ClassifyParams& p) { p.passes = 0xffffffffu; });
       }},
      {"no_groups", "zero groups a tile: lists stand, dispatches do nothing",
       [] { return changed(numbered_tiles(), [](ClassifyParams& p) { p.groups_per_tile = 0; }); }},
      {"too_many_groups", "2^32 - 1 groups a tile: saturated at what a dimension may hold",
       [] { return changed(numbered_tiles(), [](ClassifyParams& p) { p.groups_per_tile = 0xffffffffu; }); }},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases = {
      {"tiles_300", "more tiles than a gathering group has threads, all in one list", [] { return column(300); }},
      {"tiles_65535", "the last list that one dimension of a dispatch holds", [] { return column(65535); }},
      {"tiles_65536", "the first that needs another dimension", [] { return column(65536); }},
      {"tiles_65537", "two planes that cannot be equal; and 65,537 x 65,535 groups are 2^32 - 1, the most that fit",
       [] { return column(65537, 65535); }},
      {"groups_saturate", "one tile more is beyond 32 bits", [] { return column(65538, 65535); }},
      {"no_pixels", "an empty screen has no tile at all",
       [] {
         return drawn({0, 0}, [](uint32_t, uint32_t) { return 0u; });
       }},
  };
  for (const Extent e : {Extent{1, 1}, {31, 33}, {32, 32}, {33, 31}, {255, 257}, {1921, 1081}, {3840, 2160}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = placements();
  for (auto& more : {tables(), sizes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  return {
      {"mark_atomic.comp", 1, "the atomic is lost", "bits_apart"},
      {"mark_atomic.comp", 2, "tiles a row are rounded down", "partial_tiles"},
      {"tile_bits.glsl", 3, "one column too many is read", "partial_tiles"},
      {"mark_reduce.comp", 4, "the upper half of each level is left out", "high_lanes"},
      {"mark_reduce.comp", 5, "the barrier of the tree is dropped", "high_lanes"},
      {"mark_subgroup.comp", 6, "the elected lane speaks for its subgroup", "bits_apart"},
      {"mark_subgroup.comp", 7, "the barrier before the store is dropped", "high_lanes"},
      {"gather.comp", 8, "any required bit will do", "required_in_part"},
      {"gather.comp", 9, "excluded bits do not exclude", "excluded_elsewhere"},
      {"gather.comp", 10, "empty tiles go to the default", "nothing"},
      {"gather.comp", 11, "the last match wins", "overlapping_rows"},
      {"gather.comp", 12, "the atomic of the group's count is lost", "tiles_300"},
      {"gather.comp", 13, "the barrier before the reservation is dropped", "tiles_300"},
      {"args.comp", 14, "group counts wrap", "groups_saturate"},
      {"args.comp", 15, "tiles beyond 65,535 are lost", "tiles_65536"},
      {"args.comp", 16, "a pass counts the tiles of the others", "passes_interleaved"},
      {"tile_or.glsl", 9001, "the slide's form: the elected lane's bits stand for all", "bits_apart"},
      {"tile_or.glsl", 9002, "lanes of other tiles join in", "straddling_subgroups"},
      {"tile_or.glsl", 9003, "only the first tile of a subgroup is served", "partial_tiles"},
  };
}

}  // namespace assay::tile_classification
