#include "kernels/tile_visit/inputs.h"

#include <algorithm>

#include "harness/groups.h"
#include "kernels/tile_visit/oracle.h"

namespace assay::tile_visit {

namespace {

using List = std::vector<uint>;

struct Lists {
  Extent extent;
  std::vector<List> lists;
  uint groups_per_tile = 4;
};

uint count_tiles(Extent e) { return static_cast<uint>(tile_count(e, kTileSide)); }

DispatchArgs dispatch(uint listed, uint groups_per_tile) {
  const Groups plane = spread_groups(listed);
  return {groups_per_tile, plane.x, listed ? plane.y : 0};
}

// What lies behind a list is tile 0: a group that works there is noticed.
Case case_of(const Lists& l) {
  const size_t room = count_tiles(l.extent);
  std::vector<uint> entries(room * l.lists.size());
  std::vector<WorkloadCount> counts;
  std::vector<DispatchArgs> args;
  for (size_t w = 0; w < l.lists.size(); ++w) {
    const auto listed = static_cast<uint>(l.lists[w].size());
    std::ranges::copy(l.lists[w], entries.begin() + static_cast<std::ptrdiff_t>(w * room));
    counts.push_back({listed, listed * l.groups_per_tile});
    args.push_back(dispatch(listed, l.groups_per_tile));
  }
  Case c{.extent = l.extent};
  c.set_params(VisitParams{l.extent.width, l.extent.height, static_cast<uint>(l.lists.size())});
  c.set_input("workload_tiles", entries);
  c.set_input("workload_counts", counts);
  c.set_input("workload_args", args);
  return c;
}

void shuffle(Pcg32& rng, List& list) {
  for (size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[rng.below(static_cast<uint32_t>(i))]);
}

// Each tile goes to one of the lists, or with `left_out` of 1 in n to none.
std::vector<List> shared_out(Pcg32& rng, Extent e, uint32_t lists, uint32_t left_out) {
  std::vector<List> all(lists);
  for (uint tile = 0; tile < count_tiles(e); ++tile)
    if (lists && rng.below(left_out) != 0) all[rng.below(lists)].push_back(tile);
  for (List& list : all) shuffle(rng, list);
  return all;
}

Case random_case(Random& r) {
  Lists l{random_extent(r, kTileSide), {}};
  const uint32_t lists = 1 + r.rng.below(kMaxVisitors);
  switch (
      r.branch({{"lists_shared_out", 0.5}, {"lists_sparse", 0.2}, {"lists_overlapping", 0.2}, {"lists_none", 0.1}})) {
    case 0:
      l.lists = shared_out(r.rng, l.extent, lists, 16);
      break;
    case 1:
      l.lists = shared_out(r.rng, l.extent, lists, 2);
      break;
    case 2:
      for (uint32_t i = 0; i < lists; ++i) l.lists.push_back(shared_out(r.rng, l.extent, 1, 4)[0]);
      break;
    default:
      l.lists.resize(r.rng.below(3));
  }
  switch (r.branch({{"groups_few", 0.5}, {"groups_many", 0.4}, {"groups_zero", 0.1}})) {
    case 0:
      l.groups_per_tile = 1 + r.rng.below(4);
      break;
    case 1:
      l.groups_per_tile = 5 + r.rng.below(28);
      break;
    default:
      l.groups_per_tile = 0;
  }
  Case c = case_of(l);
  auto args = std::vector(c.input<DispatchArgs>("workload_args").begin(), c.input<DispatchArgs>("workload_args").end());
  auto lists_in = std::vector(c.input<uint>("workload_tiles").begin(), c.input<uint>("workload_tiles").end());
  switch (r.branch({{"honest", 0.7}, {"too_many_groups", 0.15}, {"tiles_out_of_range", 0.15}})) {
    case 0:
      break;
    case 1:
      for (DispatchArgs& a : args) a.y += r.rng.below(40), a.z += r.rng.below(2);
      break;
    default:
      for (uint& tile : lists_in)
        if (r.rng.below(4) == 0) tile = r.rng.next();
  }
  c.set_input("workload_args", args);
  c.set_input("workload_tiles", lists_in);
  return c;
}

List every_tile(Extent e) {
  List list(count_tiles(e));
  for (uint i = 0; i < list.size(); ++i) list[i] = i;
  return list;
}

Case column(uint32_t tiles) {
  const Extent e{1, tiles * kTileSide};
  return case_of({e, {every_tile(e), {}, {tiles - 1}}, 1});
}

template <class T, class F>
Case changed(Case c, const char* port, F change) {
  std::vector<T> values(c.input<T>(port).begin(), c.input<T>(port).end());
  change(values);
  c.set_input(port, values);
  return c;
}

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = {
      {"one_tile_of_nine", "a tile's neighbours on all sides must not be touched",
       [] {
         return case_of({{96, 96}, {{4}}});
       }},
      {"partial_tile", "the tile ends within a row: one column further is the next row",
       [] {
         return case_of({{40, 37}, {{1}, {3}}});
       }},
      {"second_workload", "the first list is empty, the second is not",
       [] {
         return case_of({{96, 64}, {{}, {5, 2}}});
       }},
      {"same_tile_in_all", "eight workloads visit the same pixels, one dispatch after another",
       [] {
         return case_of({{64, 64}, std::vector<List>(kMaxVisitors, {1, 2})});
       }},
      {"one_group_a_tile", "a group of 64 walks all 1024 pixels",
       [] {
         return case_of({{65, 65}, {every_tile({65, 65})}, 1});
       }},
      {"seven_groups_a_tile", "groups that do not divide the tile",
       [] {
         return case_of({{65, 65}, {every_tile({65, 65})}, 7});
       }},
      {"more_groups_than_pixels", "most groups have no pixel",
       [] {
         return case_of({{40, 40}, {{0, 3}}, 100});
       }},
      {"no_groups", "nothing may be visited",
       [] {
         return case_of({{40, 40}, {{0, 3}}, 0});
       }},
      {"no_workloads", "no dispatch at all",
       [] {
         return case_of({{40, 40}, {}});
       }},
      {"empty_lists", "dispatches of no group",
       [] {
         return case_of({{40, 40}, {{}, {}}});
       }},
      {"groups_left_over", "more groups than entries: tile 0 lies behind the list",
       [] {
         return changed<DispatchArgs>(case_of({{96, 96}, {{4, 5}, {6}}}), "workload_args",
                                      [](auto& args) { args[0].y = 3, args[1].z = 2; });
       }},
      {"count_beyond_room", "a count of 2^32 - 1: the room of the list is the limit",
       [] {
         return changed<WorkloadCount>(changed<DispatchArgs>(case_of({{64, 64}, {{3, 2, 1, 0}, {}}}), "workload_args",
                                                             [](auto& args) { args[0].y = 9; }),
                                       "workload_counts", [](auto& counts) { counts[0].tiles = 0xffffffffu; });
       }},
      {"tile_number_wraps", "tile 2^27 x 3: its top row wraps to 0",
       [] {
         return case_of({{96, 96}, {{0x18000000u, 4, 0xffffffffu, 9}}});
       }},
      {"entries_65535", "the longest list of one plane", [] { return column(65535); }},
      {"entries_65536", "the shortest of two", [] { return column(65536); }},
      {"entries_65537", "two planes and a group left over", [] { return column(65537); }},
  };
  for (const Extent e : {Extent{1, 1}, {31, 33}, {32, 32}, {33, 31}, {1921, 1081}})
    all.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height), "a size at or beside a boundary",
                   [e] { return typical(e); }});
  all.push_back({"size_3840x2160", "the frame's largest view", [] { return typical({3840, 2160}); }, true});
  return all;
}

// Without one workload, and with half of each list.
std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  const auto halved = changed<WorkloadCount>(c, "workload_counts", [](auto& counts) {
    for (WorkloadCount& count : counts) count.tiles /= 2;
  });
  if (halved.inputs != c.inputs) cases.push_back(halved);
  for (size_t w = 0; w < workloads(c); ++w) {
    const auto emptied = changed<WorkloadCount>(c, "workload_counts", [&](auto& counts) { counts[w].tiles = 0; });
    if (emptied.inputs != c.inputs) cases.push_back(emptied);
  }
  return cases;
}

}  // namespace

Case typical(Extent e) {
  Pcg32 rng(0x715e);
  return case_of({e, shared_out(rng, e, 3, 16), 16});
}

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"lists_shared_out", "lists_sparse", "lists_overlapping", "lists_none", "groups_few",
                        "groups_many", "groups_zero", "honest", "too_many_groups", "tiles_out_of_range"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

std::vector<Mutant> mutants() {
  return {
      {"visit.comp", 1, "the second plane starts over", "entries_65536"},
      {"visit.comp", 2, "groups left over work on what lies behind the list", "groups_left_over"},
      {"visit.comp", 3, "always the first workload's list", "second_workload"},
      {"visit.comp", 4, "tiles that there are not are visited", "tile_number_wraps"},
      {"visit.comp", 5, "each group works on all that follows", "one_tile_of_nine"},
      {"visit.comp", 6, "one column too many", "partial_tile"},
  };
}

}  // namespace assay::tile_visit
