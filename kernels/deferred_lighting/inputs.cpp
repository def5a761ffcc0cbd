#include "kernels/deferred_lighting/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "harness/clusters.h"
#include "harness/crop.h"
#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/vrcs_screens.h"
#include "kernels/deferred_lighting/picture.h"

namespace assay::deferred_lighting {

using glm::dvec3;

namespace {

// Every byte pattern is a G-buffer.
void add_noise(Picture& p, Pcg32& rng) {
  for (size_t i = 0; i < p.depth.size(); ++i) {
    p.base[i] = rng.next(), p.emissive[i] = rng.below(4) ? 0 : rng.next() & 0x7fffffffu;
    p.normal[i] = rng.next(), p.metal[i] = static_cast<uint16_t>(rng.next());
    p.features[i] = rng.next();
  }
}

// Slanted rectangles, each with materials of its own, normals that mostly face the eye.
void add_rectangles(Picture& p, Pcg32& rng, uint32_t count, double least, double most) {
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t x0 = rng.below(p.extent.width), y0 = rng.below(p.extent.height);
    const uint32_t x1 = std::min(p.extent.width, x0 + 1 + rng.below(p.extent.width / 2 + 8));
    const uint32_t y1 = std::min(p.extent.height, y0 + 1 + rng.below(p.extent.height / 2 + 8));
    const double depth = least * std::pow(most / least, rng.unit()), slant = rng.range(-0.3, 0.3) / (x1 - x0);
    const uint32_t base = rng.next();
    const uint16_t metal = metal_code(rng.below(3) ? 0 : rng.below(256), 100 + rng.below(156));
    const dvec3 bend = {rng.range(-1, 1), rng.range(-1, 1), 0.7};
    for (uint32_t y = y0; y < y1; ++y)
      for (uint32_t x = x0; x < x1; ++x) {
        p.place(x, y, depth * (1 + slant * (x - x0)));
        p.face(x, y, bend + 0.02 * dvec3(x - x0, y - y0, 0));
        p.base[p.at(x, y)] = base, p.metal[p.at(x, y)] = metal;
      }
  }
}

void turn(Picture& p, Pcg32& rng) {
  const double a = rng.range(0, 6.28), b = rng.range(-1.5, 1.5);
  const auto turned = [&](const vec3& v) {
    const dvec3 y = {v.x, std::cos(b) * v.y - std::sin(b) * v.z, std::sin(b) * v.y + std::cos(b) * v.z};
    return vec3(std::cos(a) * y.x + std::sin(a) * y.z, y.y, std::cos(a) * y.z - std::sin(a) * y.x);
  };
  p.params.rays = {turned(p.params.rays.corner), turned(p.params.rays.across), turned(p.params.rays.down)};
}

void break_lights(Picture& p, Pcg32& rng) {
  constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            0,
                            1e-40f,
                            -1,
                            1e20f,
                            3e38f};
  for (LightRecord& light : p.lights) {
    if (rng.below(3) != 0) continue;
    std::array<float, sizeof(LightRecord) / 4> words;
    std::memcpy(words.data(), &light, sizeof light);
    words[rng.below(words.size())] = kBad[rng.below(std::size(kBad))];
    std::memcpy(&light, words.data(), sizeof light);
    if (rng.below(4) == 0) light.kind = rng.below(6);
  }
}

// Lists that are nobody's, of which a pixel still has one result at most: tiles of which there is nothing, less or all,
// and entries of the screen's list that are none.
void spoil(Case& c, Pcg32& rng) {
  const auto words = c.input<uint32_t>("tiles"), listed = c.input<uint32_t>("list");
  std::vector<uint32_t> tiles(words.begin(), words.end()), list(listed.begin(), listed.end());
  for (uint32_t& word : tiles) {
    const uint32_t count = word & kVrcsTileCount, flags = rng.next() & ~kVrcsTileCount;
    const uint32_t fewer = count <= kVrcsTileEntries ? word - rng.below(count + 1) : word;
    const uint32_t odd[] = {word, fewer, flags, flags | (kVrcsTileEntries + 1 + rng.below(287))};
    word = odd[rng.below(4)];
  }
  for (uint32_t& entry : list)
    if (rng.below(8) == 0) entry |= rng.below(2) ? kEntryInvalid : 0x3fffu;
  c.set_input("tiles", tiles);
  c.set_input("list", list);
}

}  // namespace

Case random_case(Random& r) {
  const Extent extent = random_extent(r, 32);
  const bool far = r.branch({{"near", 0.85}, {"far", 0.15}}) != 0;
  const double least = far ? 100 : 0.5, most = far ? 1e5 : 30;
  Picture p = wall(extent, far ? 1000 : 4);
  if (r.branch({{"turned", 0.8}, {"straight", 0.2}}) == 0) turn(p, r.rng);
  p.params.near_plane = static_cast<float>(r.rng.range(0.01, 0.5));
  if (r.branch({{"all_covered", 0.7}, {"holes", 0.3}}) != 0)
    for (float& d : p.depth) d = r.rng.below(3) ? d : 0;
  switch (r.branch({{"rectangles", 0.75}, {"noise", 0.25}})) {
    case 0:
      add_rectangles(p, r.rng, 1 + r.rng.below(30), least, most);
      break;
    default:
      add_noise(p, r.rng);
  }
  if (r.branch({{"plain_surfaces", 0.6}, {"featured_surfaces", 0.4}}) != 0)
    for (uint32_t& f : p.features) f = r.rng.next();
  switch (r.branch({{"lights_none", 0.05}, {"lights_few", 0.75}, {"lights_many", 0.2}})) {
    case 0:
      break;
    case 1:
      add_lights(p, r.rng, 1 + r.rng.below(8), far ? 1000 : 4);
      break;
    default:
      add_lights(p, r.rng, 9 + r.rng.below(90), far ? 500 : 2);
  }
  if (r.branch({{"shadows_none", 0.5}, {"shadows_some", 0.5}}) != 0) add_shadows(p, r.rng);
  if (r.branch({{"lights_whole", 0.8}, {"lights_broken", 0.2}}) != 0) break_lights(p, r.rng);
  p.params.frame = r.rng.next();
  p.rates = vrcs::random_rates(r, extent);
  p.visibility = covered_by_depth(p);
  if (r.branch({{"covered_where_deep", 0.8}, {"covered_elsewhere", 0.2}}) != 0)
    for (uvec2& seen : p.visibility)
      if (r.rng.below(9) == 0) seen = r.rng.below(2) ? uvec2(r.rng.next(), 1) : uvec2(kVisibilityNone);
  Case c = to_case("random", p);
  if (r.branch({{"lists_made", 0.85}, {"lists_spoilt", 0.15}}) != 0) spoil(c, r.rng);
  return c;
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b : {"near",
                        "far",
                        "turned",
                        "straight",
                        "all_covered",
                        "holes",
                        "rectangles",
                        "noise",
                        "plain_surfaces",
                        "featured_surfaces",
                        "lights_none",
                        "lights_few",
                        "lights_many",
                        "shadows_none",
                        "shadows_some",
                        "lights_whole",
                        "lights_broken",
                        "covered_where_deep",
                        "covered_elsewhere",
                        "lists_made",
                        "lists_spoilt"})
    all.push_back(b);
  all.insert(all.end(), vrcs::kRateBranches.begin(), vrcs::kRateBranches.end());
  return all;
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  const auto params = c.params<LightingParams>();
  const auto visibility = c.input<uvec2>("visibility");
  const auto lights = c.input<LightRecord>("lights");
  const auto with_lights = [&](std::span<const LightRecord> some) {
    Case part = c;
    LightingParams fewer = params;
    fewer.lights = static_cast<uint32_t>(some.size());
    part.set_params(fewer);
    part.set_input("lights", some);
    found.push_back(std::move(part));
  };
  if (const size_t half = lights.size() / 2; half > 0)
    with_lights(lights.first(half)), with_lights(lights.subspan(half));
  if (lights.size() == 1) with_lights({});
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case part = c;
    LightingParams cut = params;
    cut.width = crop.size.width, cut.height = crop.size.height;
    // The rays keep their pixels up to the corner's rounding.
    cut.rays.corner +=
        cut.rays.across * static_cast<float>(crop.at.width) + cut.rays.down * static_cast<float>(crop.at.height);
    part.extent = crop.size;
    part.set_params(cut);
    part.set_input("depth", cropped(c.input<float>("depth"), c.extent, crop));
    part.set_input("metallic_occlusion", cropped(c.input<uint16_t>("metallic_occlusion"), c.extent, crop));
    for (const char* words : {"base_roughness", "normal", "emissive", "features", "depth_gradients"})
      part.set_input(words, cropped(c.input<uint32_t>(words), c.extent, crop));
    set_primaries(part, {.extent = crop.size, .params = params, .visibility = cropped(visibility, c.extent, crop)});
    found.push_back(std::move(part));
  }
  return found;
}

Case typical_with(Extent extent, uint32_t lights) {
  Pcg32 rng(1);
  Picture p = hall(extent);
  p.lights = {directional({0.4, -1, -0.6}, vec3(2, 1.9f, 1.7f)), point({1, 1.5, -3}, 8, vec3(20, 14, 8)),
              spot({-2.5, 3, -3}, {0.3, -1, -0.4}, 12, 0.3, 0.6, vec3(60, 70, 90))};
  if (lights > 3) add_lights(p, rng, lights - 3, 1.5);
  p.rates = vrcs::rates_in_blocks(extent, rng, 4);
  add_hall_shadows(p);
  return to_case("typical", p);
}

Case typical(Extent extent) { return typical_with(extent, 3); }

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(LightingParams{f.rays, f.near_plane, f.ambient, f.extent.width, f.extent.height, f.scene.lights, f.grid,
                              list_capacity(f.grid), f.frame, f.shadows.views, f.shadows.width, f.shadows.height});
  return c;
}

}  // namespace assay::deferred_lighting
