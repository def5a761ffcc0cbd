#include "kernels/particle_light_atlas/inputs.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <limits>

#include "harness/clusters.h"
#include "harness/groups.h"
#include "harness/light_records.h"
#include "harness/particle_scenes.h"
#include "harness/particles.h"

namespace assay::particle_light_atlas {

using glm::dvec3;

namespace {

constexpr uint32_t kPixels = 256;
constexpr float kNear = 0.1f;

}  // namespace

Scene::Scene(uint32_t side) {
  constexpr float half = kPixels / 2;
  params.side = side, params.near_plane = kNear, params.ambient = vec3(0.02f, 0.03f, 0.04f);
  params.depth = vec3(0, 0, -1), params.column = vec3(half, 0, -half), params.row = vec3(0, -half, -half);
}

ParticleRegion Scene::region(uint32_t size) const {
  return particle_region({params.side, {params.side / 4, params.side / 4, params.side / 2}}, size);
}

bool Scene::add(const ParticleRecord& p, uint32_t size) {
  const ParticleRegion r = region(size);
  particles.push_back(p);
  rects.push_back(kNoRect);
  if (placed[size] == r.slots) return false;
  const uint32_t slot = placed[size]++, x = slot % r.across * r.side, y = r.row + slot / r.across * r.side;
  rects.back() = x / 8 | y / 8 << kRectYShift | size << kRectSizeShift;
  const auto particle = static_cast<uint32_t>(particles.size()) - 1;
  for (uint32_t k = 0; k < (r.side / 8) * (r.side / 8); ++k) blocks.push_back(particle << kLightBlockBits | k);
  return true;
}

void Scene::add_cells(uint32_t pixels, const std::vector<float>& depths,
                      const std::function<std::vector<uint32_t>(uint32_t)>& lights_in) {
  params.grid = grid_over({kPixels, kPixels}, {pixels, pixels}, static_cast<uint32_t>(depths.size()) - 1);
  slice_edges = reversed_slice_edges(depths, params.near_plane);
  for (uint32_t i = 0; i < params.grid.columns * params.grid.rows * params.grid.slices; ++i) {
    const std::vector<uint32_t> some = lights_in(i);
    cells.emplace_back(entries.size(), some.size());
    entries.insert(entries.end(), some.begin(), some.end());
  }
}

void Scene::add_shadows(Pcg32& rng, const dvec3& seen) {
  constexpr uint32_t kLights = 8, kSide = 32;
  shadows = shadowing::Atlas({kLights * kSide, kLights * kSide});
  for (uint32_t i = 0; i < std::min<size_t>(lights.size(), kLights); ++i)
    shadows.add_light({0, i * kSide, kSide}, lights[i], seen, rng);
}

Case to_case(Scene s) {
  if (s.params.grid.cell_width == 0) {
    Pcg32 rng(s.lights.size());
    const auto all = static_cast<uint32_t>(s.lights.size());
    s.add_cells(48, slice_edges(0.5, 60, 4), [&](uint32_t) {
      std::vector<uint32_t> some;
      for (uint32_t i = 0; i < all && some.size() < kMaxClusterEntries; ++i)
        if (all <= 8 || rng.below(all) < 8) some.push_back(i);
      return some;
    });
  }
  Case c = {.extent = {s.params.side, s.params.side}};
  s.params.particles = static_cast<uint32_t>(s.particles.size());
  s.params.blocks = static_cast<uint32_t>(s.blocks.size());
  s.params.lights = static_cast<uint32_t>(s.lights.size());
  s.params.entries = static_cast<uint32_t>(s.entries.size());
  s.params.shadow_views = static_cast<uint32_t>(s.shadows.views.size());
  s.params.shadow_width = s.shadows.extent.width, s.params.shadow_height = s.shadows.extent.height;
  const Groups groups = spread_groups((s.blocks.size() + kLightGroupBlocks - 1) / kLightGroupBlocks);
  c.set_params(s.params);
  c.set_input("particles", s.particles);
  c.set_input("rects", s.rects);
  c.set_input("blocks", s.blocks);
  c.set_input("counts", std::vector<ParticleRectCounts>{{s.params.blocks, 0, 0, 0}});
  c.set_input("args", std::vector<DispatchArgs>{{groups.x, groups.y, groups.z}});
  c.set_input("lights", s.lights);
  c.set_input("cells", s.cells);
  c.set_input("entries", s.entries);
  c.set_input("slice_edges", s.slice_edges);
  c.set_input("shadow_views", s.shadows.views);
  c.set_input("shadow_depth", s.shadows.depths);
  return c;
}

Case typical(Extent e) {
  Pcg32 rng(0x11a7);
  Scene s(std::clamp(e.width, 64u, kMostAtlasSide) / 32 * 32);
  for (uint32_t size = 3; size > 0; --size)
    while (s.add(random_particle(rng, 1, 40), size)) {
    }
  for (uint32_t i = 0; i < 60; ++i) {
    const double z = rng.range(2, 30);
    s.lights.push_back(random_light(rng, {z * rng.range(-1, 1), z * rng.range(-1, 1), -z}, 4));
  }
  s.add_shadows(rng, {0, 0, -6});
  return to_case(s);
}

Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  const ParticleAtlas atlas = particle_atlas_of(f.particles.particles);
  // Of view depth w: w (corner + across x + down y) is the position.
  const glm::dmat3 rows =
      glm::transpose(glm::inverse(glm::dmat3(dvec3(f.rays.across), dvec3(f.rays.down), dvec3(f.rays.corner))));
  c.set_params(ParticleLightParams{.side = atlas.side,
                                   .particles = f.particles.particles,
                                   .blocks = most_particle_blocks(atlas, f.particles.particles),
                                   .lights = f.scene.lights,
                                   .ambient = f.ambient,
                                   .frame = f.frame,
                                   .column = vec3(rows[0]),
                                   .row = vec3(rows[1]),
                                   .depth = vec3(rows[2]),
                                   .near_plane = f.near_plane,
                                   .grid = f.grid,
                                   .entries = list_capacity(f.grid),
                                   .shadow_views = f.shadows.views,
                                   .shadow_width = f.shadows.width,
                                   .shadow_height = f.shadows.height});
  return c;
}

namespace {

void break_words(std::span<std::byte> bytes, Pcg32& rng, uint32_t stride) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  constexpr float kBad[] = {kNan, kInf, -kInf, 0, 1e-40f, -1, 1e20f, 3e38f};
  for (size_t at = 0; at + stride <= bytes.size(); at += stride)
    if (rng.below(3) == 0)
      std::memcpy(bytes.data() + at + 4 * rng.below(stride / 4), &kBad[rng.below(std::size(kBad))], 4);
}

// Rectangles that are none, and blocks of nobody's, of none, or listed twice. None of them overlap.
void spoil(Scene& s, Pcg32& rng) {
  for (uint32_t& w : s.rects) {
    const uint32_t odd[] = {kNoRect, w | kRectXBits, w | kRectXBits << kRectYShift, 0xffffffffu, w & 0x3ffffu};
    if (rng.below(4) == 0) w = odd[rng.below(std::size(odd))];
  }
  for (uint32_t& w : s.blocks) {
    const auto past = static_cast<uint32_t>(s.particles.size()) << kLightBlockBits;
    const uint32_t odd[] = {0xffffffffu, past, w | 15u, s.blocks[rng.below(static_cast<uint32_t>(s.blocks.size()))]};
    if (rng.below(4) == 0) w = odd[rng.below(std::size(odd))];
  }
}

Case random_case(Random& r) {
  Pcg32& rng = r.rng;
  constexpr uint32_t kSides[] = {64, 128, 256, 512};
  Scene s(kSides[r.branch({{"side_64", 0.3}, {"side_128", 0.35}, {"side_256", 0.25}, {"side_512", 0.1}})]);
  const bool far = r.branch({{"near", 0.85}, {"far", 0.15}}) == 1;
  const double nearest = far ? 100 : 0.4, farthest = far ? 1e4 : 40;
  const double filled = r.branch({{"full", 0.4}, {"sparse", 0.6}}) == 0 ? 1 : rng.range(0.05, 0.6);
  for (uint32_t size = 3; size > 0; --size) {
    const auto count = static_cast<uint32_t>(std::ceil(filled * s.region(size).slots));
    for (uint32_t i = 0; i < count; ++i) s.add(random_particle(rng, nearest, farthest), size);
  }
  uint32_t lights = 0;
  switch (r.branch({{"lights_none", 0.05}, {"lights_few", 0.75}, {"lights_many", 0.2}})) {
    case 0:
      break;
    case 1:
      lights = 1 + rng.below(8);
      break;
    default:
      lights = 9 + rng.below(60);
  }
  for (uint32_t i = 0; i < lights; ++i) {
    const vec3& at = s.particles[rng.below(static_cast<uint32_t>(s.particles.size()))].centre;
    s.lights.push_back(random_light(rng, dvec3(at), far ? 500 : 3));
  }
  if (r.branch({{"no_shadows", 0.5}, {"shadows", 0.5}}) == 1) s.add_shadows(rng, dvec3(s.particles[0].centre));
  s.params.frame = rng.next();
  if (r.branch({{"lights_whole", 0.8}, {"lights_broken", 0.2}}) == 1)
    break_words(std::as_writable_bytes(std::span(s.lights)), rng, sizeof(LightRecord));
  if (r.branch({{"particles_whole", 0.85}, {"particles_broken", 0.15}}) == 1)
    break_words(std::as_writable_bytes(std::span(s.particles)), rng, sizeof(ParticleRecord));
  switch (r.branch({{"allocated", 0.8}, {"words_garbage", 0.2}})) {
    case 0:
      break;
    default:
      spoil(s, rng);
  }
  return to_case(s);
}

// With half of the particles' blocks, or of the lights.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> cases;
  const auto blocks = c.input<uint32_t>("blocks");
  for (const size_t parts : {2u, 8u, 64u})
    for (size_t k = 0; k < parts && blocks.size() >= parts; ++k) {
      Case part = c;
      const size_t from = blocks.size() * k / parts, to = blocks.size() * (k + 1) / parts;
      auto params = c.params<ParticleLightParams>();
      params.blocks = static_cast<uint32_t>(to - from);
      part.set_params(params);
      part.set_input("blocks", blocks.subspan(from, to - from));
      part.set_input("counts", std::vector<ParticleRectCounts>{{params.blocks, 0, 0, 0}});
      cases.push_back(std::move(part));
    }
  const auto lights = c.input<LightRecord>("lights");
  for (const size_t keep : {lights.size() / 2, lights.size() - 1}) {
    if (lights.empty()) break;
    Case part = c;
    auto params = c.params<ParticleLightParams>();
    params.lights = static_cast<uint32_t>(keep);
    part.set_params(params);
    part.set_input("lights", lights.first(keep));
    cases.push_back(std::move(part));
  }
  return cases;
}

}  // namespace

Inputs inputs() {
  return {.random = random_case,
          .branches = {"side_64", "side_128", "side_256", "side_512", "near", "far", "full", "sparse", "lights_none",
                       "lights_few", "lights_many", "no_shadows", "shadows", "lights_whole", "lights_broken",
                       "particles_whole", "particles_broken", "allocated", "words_garbage"},
          .hard = hard_cases(),
          .smaller = smaller};
}

}  // namespace assay::particle_light_atlas
