#include "kernels/hi_z/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/crop.h"

namespace assay::hi_z {

Case case_of(Extent e, const std::vector<float>& depth) {
  Case c{.extent = e};
  c.set_params(HiZParams{e.width, e.height});
  c.set_input("depth", depth);
  return c;
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(HiZParams{f.extent.width, f.extent.height});
  return c;
}

namespace {

// Each with its own depth, slanted along x.
void add_walls(Pcg32& rng, Extent e, std::vector<float>& depth, uint32_t count) {
  for (; count > 0; --count) {
    const uint32_t left = rng.below(e.width), top = rng.below(e.height);
    const uint32_t right = left + 1 + rng.below(e.width - left), bottom = top + 1 + rng.below(e.height - top);
    const double at = std::pow(10, rng.range(-4, -0.5)), slant = rng.range(-0.3, 0.3) / (right - left);
    for (uint32_t y = top; y < bottom; ++y)
      for (uint32_t x = left; x < right; ++x)
        depth[size_t{y} * e.width + x] = static_cast<float>(at * (1 + slant * (x - left)));
  }
}

void add_floor(Extent e, std::vector<float>& depth) {
  const uint32_t horizon = e.height / 3;
  for (uint32_t y = horizon; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x)
      depth[size_t{y} * e.width + x] = 0.05f * static_cast<float>(y - horizon + 1) / static_cast<float>(e.height);
}

void sprinkle(Pcg32& rng, std::vector<float>& depth, uint64_t count, std::span<const float> values) {
  for (; count > 0 && !depth.empty(); --count)
    depth[rng.below(static_cast<uint32_t>(depth.size()))] = values[rng.below(static_cast<uint32_t>(values.size()))];
}

}  // namespace

Case typical(Extent e) {
  std::vector<float> depth(pixel_count(e), 0.0f);
  Pcg32 rng(0x412);
  add_floor(e, depth);
  add_walls(rng, e, depth, 12);
  return case_of(e, depth);
}

namespace {

Case random_case(Random& r) {
  const Extent e = random_extent(r, 32);
  std::vector<float> depth(pixel_count(e), 0.0f);
  constexpr float kOdd[] = {NAN, -NAN, INFINITY, -INFINITY, -0.0f, -0.5f, 1e-40f, 0x1p-149f, 2, 3e38f};
  constexpr float kEnds[] = {0, 1};
  switch (r.branch({{"content_flat", 0.1},
                    {"content_noise", 0.25},
                    {"content_walls", 0.35},
                    {"content_one_pixel", 0.15},
                    {"content_odd", 0.15}})) {
    case 0:
      std::ranges::fill(depth, static_cast<float>(r.rng.unit()));
      break;
    case 1:
      for (float& d : depth) d = static_cast<float>(r.rng.unit());
      break;
    case 2:
      add_floor(e, depth), add_walls(r.rng, e, depth, r.rng.below(9));
      break;
    case 3:
      std::ranges::fill(depth, 0.25f), sprinkle(r.rng, depth, 1, kEnds);
      break;
    default:
      for (float& d : depth) d = static_cast<float>(r.rng.unit());
      sprinkle(r.rng, depth, depth.size() / (1 + r.rng.below(40)) + 1, kOdd);
  }
  if (r.branch({{"as_drawn", 0.7}, {"holes", 0.3}}) == 1)
    sprinkle(r.rng, depth, depth.size() / (1 + r.rng.below(100)), std::span(kEnds, 1));
  return case_of(e, depth);
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent))
    cases.push_back(case_of(crop.size, cropped(c.input<float>("depth"), c.extent, crop)));
  for (Case& smaller : cases) smaller.name = c.name, smaller.seed = c.seed;
  return cases;
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b :
       {"content_flat", "content_noise", "content_walls", "content_one_pixel", "content_odd", "as_drawn", "holes"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::hi_z
