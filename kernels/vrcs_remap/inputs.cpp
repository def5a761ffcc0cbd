#include "kernels/vrcs_remap/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/crop.h"
#include "harness/groups.h"
#include "kernels/vrcs_remap/oracle.h"

namespace assay::vrcs_remap {

namespace {

using vrcs::Pictured;
using vrcs::Tile;

void set_list(Case& c, const std::vector<Tile>& tiles, Pcg32& rng) {
  std::vector<size_t> order(tiles.size());
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    std::swap(order[i], order[rng.below(static_cast<uint32_t>(i + 1))]);
  }
  std::vector<uint> list;
  for (const size_t t : order)
    for (const vrcs::Primary& p : tiles[t].primaries)
      list.push_back(p.x | p.y << kEntryCoordinateBits | p.copies << kEntryCopyShift);
  const Groups groups = spread_groups((list.size() + kVrcsListGroup - 1) / kVrcsListGroup);
  c.set_input("list_count", std::vector{static_cast<uint>(list.size())});
  c.set_input("list_args", std::vector{DispatchArgs{groups.x, groups.y, 1}});
  list.resize(pixels(c), kCopyBits << kEntryCopyShift);
  c.set_input("list", list);
}

}  // namespace

Case case_of(const vrcs::View& view, uint64_t seed) {
  Case c{.extent = view.extent};
  c.set_params(RemapParams{view.extent.width, view.extent.height, view.frame, 0});
  c.set_input("visibility", view.visibility);
  Pcg32 rng(seed);
  const auto coordinates = vrcs::coordinates_of(view);
  const bool with_depth = rng.below(2) == 1;
  std::vector<uint> words, entries(coordinates.tiles.size() * kVrcsTileEntries, 0xffffffffu);
  for (size_t t = 0; t < coordinates.tiles.size(); ++t) {
    const Tile& tile = coordinates.tiles[t];
    words.push_back(tile.word);
    if (!vrcs::is_stored(tile)) continue;
    for (size_t i = 0; i < tile.primaries.size(); ++i)
      entries[t * kVrcsTileEntries + i] =
          vrcs::entry_of(tile.primaries[i]) | (with_depth ? rng.next() << kVrcsEntryDepthShift : 0);
  }
  c.set_input("tiles", words);
  c.set_input("entries", entries);
  set_list(c, coordinates.tiles, rng);
  return c;
}

Case hostile(Case c, const std::string& input, const std::function<void(std::vector<uint>&)>& change) {
  auto params = c.params<RemapParams>();
  params.hostile = 1;
  c.set_params(params);
  std::vector<uint> words(c.input<uint>(input).begin(), c.input<uint>(input).end());
  change(words);
  c.set_input(input, words);
  return c;
}

Case typical(Extent e) { return case_of(vrcs::typical_screen(e).view(0), 1); }

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(RemapParams{f.extent.width, f.extent.height, f.frame, 0});
  return c;
}

namespace {

// One word in `one_in` by any other.
Case spoiled(Random& r, Case c, const std::string& input, uint32_t one_in) {
  return hostile(std::move(c), input, [&](std::vector<uint>& words) {
    for (uint& word : words)
      if (r.rng.below(one_in) == 0) word = r.rng.next() >> r.rng.below(32);
  });
}

Case random_case(Random& r) {
  const Pictured s = vrcs::random_screen(r, random_extent(r, 32));
  vrcs::View view = s.view(r.rng.next());
  if (r.branch({{"clear", 0.6}, {"fogged", 0.4}}) == 1)
    view.fog_depth = static_cast<float>(std::pow(10, r.rng.range(-4, 0)));
  view.all_1x1 = r.branch({{"by_rates", 0.9}, {"new_view", 0.1}}) == 1;
  Case c = case_of(view, r.rng.next());
  switch (r.branch({{"lists_made", 0.6}, {"lists_spoiled", 0.3}, {"lists_random", 0.1}})) {
    case 0:
      return c;
    case 1:
      for (const char* input : {"tiles", "entries", "list"}) c = spoiled(r, std::move(c), input, 2 + r.rng.below(30));
      return c;
    default:
      for (const char* input : {"tiles", "entries", "list", "list_count"}) c = spoiled(r, std::move(c), input, 1);
      return c;
  }
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  branches.insert(branches.end(), vrcs::kScreenBranches.begin(), vrcs::kScreenBranches.end());
  for (const char* b : {"clear", "fogged", "by_rates", "new_view", "lists_made", "lists_spoiled", "lists_random"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases()};
}

}  // namespace assay::vrcs_remap
