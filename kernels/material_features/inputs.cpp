#include "kernels/material_features/inputs.h"

#include <algorithm>
#include <limits>

#include "harness/crop.h"
#include "kernels/material_features/layout.h"

namespace assay::material_features {
namespace {

struct Scene {
  Extent extent = {};
  std::vector<uvec2> visibility = {};
  std::vector<SurfaceRecord> surfaces = {};
  std::vector<MaterialRecord> materials = {};
};

Case to_case(std::string name, const Scene& s) {
  Case c = {.name = std::move(name), .extent = s.extent};
  c.set_params(FeatureParams{s.extent.width, s.extent.height, static_cast<uint32_t>(s.surfaces.size()),
                             static_cast<uint32_t>(s.materials.size())});
  c.set_input("visibility", s.visibility);
  c.set_input("surfaces", s.surfaces);
  c.set_input("materials", s.materials);
  return c;
}

// What the kernel must not look at holds what would hurt it if it did.
SurfaceRecord surface_of(uint32_t material) {
  const vec4 hostile = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e-40f, -0.0f};
  return {hostile, hostile, hostile, hostile, hostile, hostile, material, ~0u, ~0u, ~0u, ~0u, ~0u};
}
MaterialRecord material_of(uint32_t features) { return {vec4(0), kNoTexture, 0.5f, ~0u, features}; }

// n surfaces over m materials in turn, material k with features k + 1, so that every material tells itself apart.
Scene scene_of(Extent extent, uint32_t n, uint32_t m) {
  Scene s = {.extent = extent, .visibility = std::vector<uvec2>(pixel_count(extent), uvec2(kVisibilityNone))};
  for (uint32_t i = 0; i < n; ++i) s.surfaces.push_back(surface_of(i % m));
  for (uint32_t i = 0; i < m; ++i) s.materials.push_back(material_of(i + 1));
  return s;
}

template <class F>
Case filled(const std::string& name, Scene s, F at) {
  for (uint32_t y = 0; y < s.extent.height; ++y)
    for (uint32_t x = 0; x < s.extent.width; ++x) s.visibility[size_t{y} * s.extent.width + x] = at(x, y);
  return to_case(name, s);
}

void add_rectangles(Scene& s, Pcg32& rng, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x0 = rng.below(s.extent.width), y0 = rng.below(s.extent.height);
    const uint32_t x1 = std::min(s.extent.width, x0 + 1 + rng.below(s.extent.width / 3 + 8));
    const uint32_t y1 = std::min(s.extent.height, y0 + 1 + rng.below(s.extent.height / 3 + 8));
    const uint32_t surface = rng.below(static_cast<uint32_t>(s.surfaces.size()));
    const uint32_t flags = rng.next() & (kVisibilityInstanced | kVisibilityFlipped);
    for (uint32_t y = y0; y < y1; ++y)
      for (uint32_t x = x0; x < x1; ++x) s.visibility[size_t{y} * s.extent.width + x] = {(x ^ y) / 4, surface | flags};
  }
}

void add_noise(Scene& s, Pcg32& rng, uint32_t one_in, uint32_t surfaces, uint32_t flags) {
  for (uvec2& v : s.visibility)
    if (rng.below(one_in) == 0) v = {rng.next(), rng.below(surfaces) | (rng.next() & flags)};
}

}  // namespace

Case random_case(Random& r) {
  const Extent extent = random_extent(r, 32);
  const uint32_t surfaces = r.branch({{"surfaces_none", 0.05}, {"surfaces_some", 0.95}}) ? 1 + r.rng.below(300) : 0;
  const uint32_t materials = 1 + r.rng.below(64);
  Scene s = scene_of(extent, surfaces, materials);
  for (MaterialRecord& m : s.materials) m.features = r.rng.next();
  for (SurfaceRecord& f : s.surfaces) f.material = r.rng.below(materials);
  if (r.branch({{"materials_in_range", 0.9}, {"materials_out_of_range", 0.1}}))
    for (SurfaceRecord& f : s.surfaces)
      if (r.rng.below(3) == 0) f.material = r.rng.next() % (2 * materials + 1);
  const uint32_t both_flags = kVisibilityInstanced | kVisibilityFlipped;
  if (surfaces) switch (r.branch({{"rectangles", 0.6}, {"noise", 0.2}, {"speckled_rectangles", 0.2}})) {
      case 0:
        add_rectangles(s, r.rng, 1 + r.rng.below(40));
        break;
      case 1:
        add_noise(s, r.rng, 1, surfaces, both_flags);
        break;
      default:
        add_rectangles(s, r.rng, 20), add_noise(s, r.rng, 16, surfaces, both_flags);
    }
  if (r.branch({{"indices_in_range", 0.8}, {"indices_out_of_range", 0.2}}))
    add_noise(s, r.rng, 8, std::max(2 * surfaces, 3u), both_flags);
  return to_case("random", s);
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b : {"surfaces_none", "surfaces_some", "materials_in_range", "materials_out_of_range", "rectangles",
                        "noise", "speckled_rectangles", "indices_in_range", "indices_out_of_range"})
    all.push_back(b);
  return all;
}

std::vector<HardCase> hard_cases() {
  const auto sizes = [](Extent e) {
    return [e] {
      return filled("", scene_of(e, 97, 13), [](uint32_t x, uint32_t y) { return uvec2(y, (x + 31 * y) % 97); });
    };
  };
  return {
      {"one_pixel", "one lane of one group is alive", sizes({1, 1})},
      {"one_group", "exactly one group", sizes({16, 16})},
      {"one_group_less_one", "the group's last row and column are off the screen", sizes({15, 15})},
      {"one_group_and_one", "three more groups for one row and one column", sizes({17, 17})},
      {"odd_extent", "rows that start in the middle of a subgroup of any width", sizes({31, 33})},
      {"wide", "width and height cannot be swapped", sizes({200, 3})},
      {"empty_screen", "no pixel has a surface and there is none to read",
       [] {
         return to_case("", scene_of({31, 33}, 0, 0));
       }},
      {"last_surface", "the highest index of surfaces and of materials, every wave uniform",
       [] {
         return filled("", scene_of({64, 64}, 5, 5), [](uint32_t, uint32_t) { return uvec2(0, 4); });
       }},
      {"every_pixel_another_surface", "no wave is uniform, every lane has its own lookup",
       [] {
         return filled("", scene_of({64, 64}, 4096, 4096), [](uint32_t x, uint32_t y) { return uvec2(7, y * 64 + x); });
       }},
      {"same_triangle_other_surface", "lanes agree on x but not on y",
       [] {
         return filled("", scene_of({64, 64}, 2, 2), [](uint32_t x, uint32_t) { return uvec2(3, x & 1); });
       }},
      {"one_lane_differs", "one pixel of a wave, at every lane in turn, has another surface",
       [] {
         return filled("", scene_of({64, 64}, 2, 2), [](uint32_t x, uint32_t y) { return uvec2(0, x % 16 == y % 16); });
       }},
      {"holes", "lanes without a surface between lanes with one",
       [] {
         return filled("", scene_of({64, 64}, 3, 3), [](uint32_t x, uint32_t y) {
           return (x + y) % 3 == 0 ? uvec2(kVisibilityNone) : uvec2(x, (x + y) % 3);
         });
       }},
      {"flags", "instanced and flipped bits above the index, in all four combinations",
       [] {
         return filled("", scene_of({64, 64}, 9, 9),
                       [](uint32_t x, uint32_t y) { return uvec2(1, y % 9 | x % 4 << 30); });
       }},
      {"surface_out_of_range", "count, count + 1, 2^30 - 2 and 2^30 - 1, with flags: no features",
       [] {
         return filled("", scene_of({64, 64}, 4, 4), [](uint32_t x, uint32_t y) {
           const uint32_t index[] = {3, 4, 5, 0x3ffffffe, 0x3fffffff};
           return uvec2(0, index[x % 5] | y % 4 << 30);
         });
       }},
      {"material_out_of_range", "count, count + 1, 2^31 and 2^32 - 1: no features",
       [] {
         Scene s = scene_of({64, 64}, 5, 3);
         const uint32_t index[] = {2, 3, 4, 0x80000000u, 0xffffffffu};
         for (uint32_t i = 0; i < 5; ++i) s.surfaces[i].material = index[i];
         return filled("", s, [](uint32_t x, uint32_t) { return uvec2(0, x % 5); });
       }},
      {"every_bit", "all 32 feature bits, and none, side by side",
       [] {
         Scene s = scene_of({64, 64}, 2, 2);
         s.materials[0].features = 0xffffffffu, s.materials[1].features = 0;
         return filled("", s, [](uint32_t x, uint32_t y) { return uvec2(0, (x ^ y) & 1); });
       }},
      {"full_hd_and_one", "an odd extent of real size", sizes({1921, 1081})},
      {"ultra_hd", "3840x2160, the largest frame", sizes({3840, 2160}), true},
  };
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case part = c;
    auto params = c.params<FeatureParams>();
    params.width = crop.size.width, params.height = crop.size.height;
    part.extent = crop.size;
    part.set_params(params);
    part.set_input("visibility", cropped(c.input<uvec2>("visibility"), c.extent, crop));
    found.push_back(std::move(part));
  }
  return found;
}

Case typical(Extent extent) {
  Pcg32 rng(1);
  Scene s = scene_of(extent, 400, 60);
  for (MaterialRecord& m : s.materials) m.features = rng.next() & 0x1fff;
  add_rectangles(s, rng, 250);
  return to_case("typical", s);
}

}  // namespace assay::material_features
