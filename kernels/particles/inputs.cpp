#include "kernels/particles/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "harness/crop.h"
#include "harness/particles.h"
#include "kernels/particles/air.h"

namespace assay::particles {

using glm::dvec3;

namespace {

void break_particles(Air& a, Pcg32& rng) {
  constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            0,
                            1e-40f,
                            -1,
                            2e6f,
                            3e38f};
  for (ParticleRecord& p : a.particles) {
    if (rng.below(3) != 0) continue;
    std::array<float, sizeof(ParticleRecord) / 4> words;
    std::memcpy(words.data(), &p, sizeof p);
    words[rng.below(words.size())] = kBad[rng.below(std::size(kBad))];
    std::memcpy(&p, words.data(), sizeof p);
  }
}

void turn(Air& a, Pcg32& rng) {
  const double y = rng.range(0, 6.28), x = rng.range(-1.5, 1.5);
  const auto turn = [&](vec3& v) { v = vec3(turned(dvec3(v), y, x)); };
  turn(a.params.rays.corner), turn(a.params.rays.across), turn(a.params.rays.down);
  set_clip_rows(a.params, a.extent);
}

// Walls nearer than some particles, holes, and depths that are none.
void break_depth(Air& a, Pcg32& rng) {
  for (uint32_t i = 0; i < 12; ++i) {
    const uint32_t x0 = rng.below(a.extent.width), y0 = rng.below(a.extent.height);
    const float odd[] = {0, 1e-31f, std::numeric_limits<float>::quiet_NaN(), static_cast<float>(rng.range(0.005, 0.2))};
    const float d = odd[rng.below(4)];
    for (uint32_t y = y0; y < std::min(a.extent.height, y0 + 9); ++y)
      for (uint32_t x = x0; x < std::min(a.extent.width, x0 + 11); ++x) a.depth[y * a.extent.width + x] = d;
  }
}

Case random_case(Random& r) {
  const Extent extent = random_extent(r, 32);
  Air a = air(extent, r.rng.range(2, 20));
  if (r.branch({{"straight", 0.5}, {"turned", 0.5}}) != 0) turn(a, r.rng);
  const uint32_t count = pixels({.extent = extent}) > 20000 ? 6 : 1 + r.rng.below(20);
  switch (r.branch({{"plume", 0.7}, {"plume_near", 0.2}, {"plume_far", 0.1}})) {
    case 0:
      add_plume(a, r.rng, count, 1, 12, 0.5);
      break;
    case 1:
      add_plume(a, r.rng, count, 0.05, 0.8, 0.3);
      break;
    default:
      add_plume(a, r.rng, count, 20, 900, 2);
  }
  if (r.branch({{"facing", 0.7}, {"aslant", 0.3}}) != 0)
    for (ParticleRecord& p : a.particles)
      p.up = vec3(turned(dvec3(p.up), r.rng.range(-1.5, 1.5), r.rng.range(-1.5, 1.5)));
  if (r.branch({{"whole", 0.8}, {"broken", 0.2}}) != 0) break_particles(a, r.rng);
  if (r.branch({{"wall", 0.6}, {"odd_depths", 0.4}}) != 0) break_depth(a, r.rng);
  const uint32_t encodings[] = {kLightR11G11B10, kLightRgb9e5, kLightRgba16};
  a.params.encoding = encodings[r.branch({{"atlas_r11g11b10f", 0.5}, {"atlas_rgb9e5", 0.25}, {"atlas_rgba16f", 0.25}})];
  const bool noise = r.branch({{"texels_whole", 0.8}, {"texels_noise", 0.2}}) != 0;
  for (uvec2& texel : a.atlas)
    texel = noise ? uvec2(r.rng.next(), r.rng.next())
                  : encoded({r.rng.unit(), 3 * r.rng.unit(), 0.1 * r.rng.unit()}, a.params.encoding);
  if (r.branch({{"rects_whole", 0.7}, {"rects_odd", 0.3}}) != 0)
    for (uint32_t& word : a.rects) word = r.rng.below(2) ? r.rng.next() : kNoRect;
  if (r.branch({{"order_whole", 0.7}, {"order_odd", 0.3}}) != 0)
    for (uint32_t& entry : a.order)
      if (r.rng.below(4) == 0) entry = r.rng.below(2) ? r.rng.next() : r.rng.below(count);
  if (r.branch({{"dark", 0.3}, {"lit", 0.7}}) != 0) add_lights(a, r.rng, 1 + r.rng.below(5));
  return to_case("random", a);
}

std::vector<std::string> branches() {
  std::vector<std::string> all = kExtentBranches;
  for (const char* b :
       {"straight",     "turned",        "plume",        "plume_near",   "plume_far",   "facing",
        "aslant",       "whole",         "broken",       "wall",         "odd_depths",  "atlas_r11g11b10f",
        "atlas_rgb9e5", "atlas_rgba16f", "texels_whole", "texels_noise", "rects_whole", "rects_odd",
        "order_whole",  "order_odd",     "dark",         "lit"})
    all.push_back(b);
  return all;
}

// Half the order or the lights, or a part of the picture, its rays up to the corner's rounding.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> found;
  const auto params = c.params<ParticlesParams>();
  const auto order = c.input<uint32_t>("order");
  const auto lights = c.input<LightRecord>("lights");
  const auto with = [&](std::span<const uint32_t> drawn, std::span<const LightRecord> lit) {
    Case part = c;
    ParticlesParams fewer = params;
    fewer.drawn = static_cast<uint32_t>(drawn.size()), fewer.lights = static_cast<uint32_t>(lit.size());
    part.set_params(fewer);
    part.set_input("order", drawn);
    part.set_input("lights", lit);
    found.push_back(std::move(part));
  };
  if (const size_t half = order.size() / 2; half > 0)
    with(order.first(half), lights), with(order.subspan(half), lights);
  if (!lights.empty()) with(order, lights.first(lights.size() / 2));
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case part = c;
    ParticlesParams cut = params;
    cut.rays.corner +=
        cut.rays.across * static_cast<float>(crop.at.width) + cut.rays.down * static_cast<float>(crop.at.height);
    set_clip_rows(cut, crop.size);
    part.extent = crop.size;
    part.set_params(cut);
    part.set_input("depth", cropped(c.input<float>("depth"), c.extent, crop));
    part.set_input("radiance", cropped(c.input<uint64_t>("radiance"), c.extent, crop));
    found.push_back(std::move(part));
  }
  return found;
}

}  // namespace

// 2000 particles of a hall's air, each over some 40 pixels' square at 1920 across.
Case typical(Extent extent) {
  Pcg32 rng(1);
  Air a = air(extent);
  a.side = 1024;
  a.atlas.clear();
  for (uint32_t i = 0; i < a.side * a.side; ++i)
    a.atlas.push_back(encoded({rng.range(0.7, 1.4), rng.range(0.3, 0.6), rng.range(1.4, 2.8)}, a.params.encoding));
  add_plume(a, rng, 2000, 2, 25, 0.2);
  add_lights(a, rng, 4);
  return to_case("typical", a);
}

Inputs inputs() { return {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller}; }

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  ParticlesParams p = {.rays = f.rays,
                       .near_plane = f.near_plane,
                       .ambient = f.ambient,
                       .particles = f.particles.particles,
                       .drawn = f.particles.drawn,
                       .atlas_side = particle_atlas_of(f.particles.particles).side,
                       .lights = f.scene.lights};
  set_clip_rows(p, f.extent);
  c.set_params(p);
  return c;
}

}  // namespace assay::particles
