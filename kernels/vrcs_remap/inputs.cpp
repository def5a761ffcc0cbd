#include "kernels/vrcs_remap/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/crop.h"
#include "harness/vrcs_lists.h"
#include "kernels/vrcs_remap/oracle.h"

namespace assay::vrcs_remap {

using vrcs::Pictured;

Case case_of(const vrcs::View& view, uint64_t seed) {
  Case c{.extent = view.extent};
  c.set_params(RemapParams{view.extent.width, view.extent.height, view.frame, 0});
  c.set_input("visibility", view.visibility);
  Pcg32 rng(seed);
  const auto coordinates = vrcs::coordinates_of(view);
  vrcs::Lists lists = vrcs::lists_of(coordinates);
  if (rng.below(2) == 1)  // with depth
    for (uint& entry : lists.entries) entry ^= rng.next() << kVrcsEntryDepthShift;
  c.set_input("tiles", lists.tiles);
  c.set_input("entries", lists.entries);
  vrcs::set_screen_list(c, coordinates.tiles, rng);
  return c;
}

Case hostile(Case c, const std::string& input, const std::function<void(std::vector<uint>&)>& change) {
  auto params = c.params<RemapParams>();
  params.hostile = 1;
  c.set_params(params);
  return vrcs::changed(std::move(c), input, change);
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
