#include "kernels/vrcs_coordinates/inputs.h"

#include <algorithm>
#include <cmath>

#include "harness/crop.h"

namespace assay::vrcs_coordinates {

using vrcs::Pictured;

namespace {

VrcsParams usual(Extent e, uint focal_x, uint focal_y) {
  return {.width = e.width,
          .height = e.height,
          .near_plane = 0.1f,
          .depth_scale = static_cast<float>(kVrcsDepthCodes / 999.9),
          .close_normals_log2 = 5,  // 10 degrees
          .close_depths_log2 = 6,
          .focal_x = focal_x,
          .focal_y = focal_y};
}

}  // namespace

Case case_of(const Pictured& s) {
  Case c{.extent = s.extent};
  const uint focal = vrcs::focal_of(s.extent);
  c.set_params(usual(s.extent, focal, focal));
  c.set_input("visibility", s.visibility);
  c.set_input("depth", s.depth);
  c.set_input("face_normals", s.face_normals);
  c.set_input("rates", s.rates);
  return c;
}

Case with_params(Case c, const std::function<void(VrcsParams&)>& change) {
  auto params = c.params<VrcsParams>();
  change(params);
  c.set_params(params);
  return c;
}

Case typical(Extent e) { return case_of(vrcs::typical_screen(e)); }

// With full rates everywhere there are no tiles.
Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.vrcs ? f.extent : Extent{0, 0}};
  // In pixels, of a view plane a metre away; a ray's steps are metres a pixel.
  const auto focal = [](const vec3& step) { return static_cast<uint>(std::lround(std::min(1e6f, 1 / length(step)))); };
  VrcsParams p = usual(f.extent, focal(f.rays.across), focal(f.rays.down));
  p.frame = f.frame;
  p.all_1x1 = f.history.luma.empty();
  p.near_plane = f.near_plane;
  c.set_params(p);
  return c;
}

namespace {

void sprinkle_depths(Pcg32& rng, Pictured& s) {
  constexpr float kOdd[] = {NAN, INFINITY, -INFINITY, -0.0f, -0.5f, 0, 1e-40f, 0x1p-126f, 3e38f, 1, 2};
  for (uint64_t n = s.depth.size() / 8 + 1; n > 0; --n)
    s.depth[rng.below(static_cast<uint32_t>(s.depth.size()))] = kOdd[rng.below(11)];
}

void random_params(Random& r, VrcsParams& p) {
  p.frame = r.rng.next();
  p.all_1x1 = r.branch({{"by_rates", 0.9}, {"new_view", 0.1}}) == 1 ? r.rng.next() | 1 : 0;
  if (r.branch({{"clear", 0.6}, {"fogged", 0.4}}) == 1)
    p.fog_depth = static_cast<float>(std::pow(10, r.rng.range(-4, 0)));
  switch (r.branch({{"limits_usual", 0.7}, {"limits_wide", 0.1}, {"limits_none", 0.1}, {"limits_odd", 0.1}})) {
    case 0:
      p.close_normals_log2 = 2 + r.rng.below(10), p.close_depths_log2 = 2 + r.rng.below(12);
      break;
    case 1:
      p.close_normals_log2 = p.close_depths_log2 = 0;
      break;
    case 2:
      p.close_normals_log2 = 31, p.close_depths_log2 = 23;
      break;
    default:
      p.close_normals_log2 = r.rng.next() >> r.rng.below(32), p.close_depths_log2 = r.rng.next() >> r.rng.below(32);
  }
  if (r.branch({{"focal_usual", 0.9}, {"focal_odd", 0.1}}) == 1) {
    constexpr uint kOdd[] = {0, 1, 16383, 16384, 0xffffffffu};
    p.focal_x = kOdd[r.rng.below(5)], p.focal_y = kOdd[r.rng.below(5)];
  }
}

Case random_case(Random& r) {
  Pictured s = vrcs::random_screen(r, random_extent(r, 32));
  if (r.branch({{"depths_drawn", 0.8}, {"depths_odd", 0.2}}) == 1) sprinkle_depths(r.rng, s);
  if (r.branch({{"normals_drawn", 0.8}, {"normals_odd", 0.2}}) == 1)
    for (uint& n : s.face_normals) n = r.rng.next();
  return with_params(case_of(s), [&](VrcsParams& p) { random_params(r, p); });
}

// Crops begin at even pixels, so that cells stay what they are.
Case cropped_case(const Case& c, Crop crop) {
  crop.at.width -= crop.at.width % 2, crop.at.height -= crop.at.height % 2;
  const Crop of_cells{{crop.at.width / 2, crop.at.height / 2}, vrcs::cells_of(crop.size)};
  Case smaller = with_params(c, [&](VrcsParams& p) { p.width = crop.size.width, p.height = crop.size.height; });
  smaller.extent = crop.size;
  smaller.set_input("visibility", cropped(c.input<uvec2>("visibility"), c.extent, crop));
  smaller.set_input("depth", cropped(c.input<float>("depth"), c.extent, crop));
  smaller.set_input("face_normals", cropped(c.input<uint>("face_normals"), c.extent, crop));
  smaller.set_input("rates", cropped(c.input<uint8_t>("rates"), vrcs::cells_of(c.extent), of_cells));
  return smaller;
}

std::vector<Case> smaller_cases(const Case& c) {
  std::vector<Case> cases;
  for (const Crop& crop : smaller_crops(c.extent)) cases.push_back(cropped_case(c, crop));
  return cases;
}

}  // namespace

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  branches.insert(branches.end(), vrcs::kScreenBranches.begin(), vrcs::kScreenBranches.end());
  for (const char* b :
       {"by_rates", "new_view", "clear", "fogged", "limits_usual", "limits_wide", "limits_none", "limits_odd",
        "focal_usual", "focal_odd", "depths_drawn", "depths_odd", "normals_drawn", "normals_odd"})
    branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller_cases};
}

}  // namespace assay::vrcs_coordinates
