#include "kernels/particle_rects/inputs.h"

#include <algorithm>
#include <limits>

#include "harness/particle_scenes.h"
#include "harness/particles.h"
#include "kernels/particle_rects/oracle.h"

namespace assay::particle_rects {

namespace {
using glm::dvec3;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
}  // namespace

Case case_of(const RectParams& p, const std::vector<ParticleRecord>& particles, std::vector<uint32_t> previous) {
  Case c = {.extent = {std::max<uint32_t>(1, static_cast<uint32_t>(particles.size())), 1}};
  RectParams params = p;
  params.particles = static_cast<uint32_t>(particles.size());
  previous.resize(particles.size());
  c.set_params(params);
  c.set_input("particles", particles);
  c.set_input("previous", previous);
  return c;
}

RectParams view(const ParticleAtlas& atlas, double width) {
  return {atlas,
          0,
          static_cast<float>(width / 2),
          0.1f,
          vec3(0, 0, -1),
          vec3(1, 0, -1),
          vec3(-1, 0, -1),
          vec3(0, -1, -1),
          vec3(0, 1, -1)};
}

// The sides lie a pixel outside, so that rounding takes away none that is seen.
Case in_frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  const dvec3 across(f.rays.across), down(f.rays.down), corner = dvec3(f.rays.corner) - across - down;
  const dvec3 right = across * (f.extent.width + 2.0), low = down * (f.extent.height + 2.0);
  const dvec3 middle = corner + 0.5 * (right + low);
  const auto inwards = [&middle](const dvec3& n) {
    return vec3(glm::normalize(n) * (glm::dot(n, middle) < 0 ? -1.0 : 1.0));
  };
  const vec3 forward = inwards(glm::cross(across, down));
  const auto pixels = static_cast<float>(glm::dot(dvec3(forward), middle) / glm::length(across));
  c.set_params(RectParams{particle_atlas_of(f.particles.particles), f.particles.particles, pixels, f.near_plane,
                          forward, inwards(glm::cross(corner, down)), inwards(glm::cross(corner + right, down)),
                          inwards(glm::cross(corner, across)), inwards(glm::cross(corner + low, across))});
  Bytes& previous = c.inputs["previous"] = f.history.particle_rects;
  previous.resize(size_t{f.particles.particles} * sizeof(uint32_t));
  return c;
}

namespace {

// Rectangles as the frame before might have left them: those that the particles would get, of all but some.
std::vector<uint32_t> left_before(const Case& c, Pcg32& rng, double kept) {
  Answer a = allocation(c);
  std::vector<uint32_t> words(c.input<ParticleRecord>("particles").size());
  std::memcpy(words.data(), a.at("rects").low.data(), a.at("rects").low.size());
  for (uint32_t& w : words)
    if (rng.unit() > kept) w = kNoRect;
  return words;
}

std::vector<ParticleRecord> puffs(Pcg32& rng, uint32_t count) {
  std::vector<ParticleRecord> particles;
  for (uint32_t i = 0; i < count; ++i) particles.push_back(random_particle(rng, 0.3, 60));
  return particles;
}

void break_particles(std::vector<ParticleRecord>& particles, Pcg32& rng) {
  constexpr float kBad[] = {kNan, kInf, -kInf, 0, -0.0f, 1e-40f, -1, 1e-30f, 1e20f, 3e38f};
  for (ParticleRecord& p : particles) {
    if (rng.below(3) != 0) continue;
    float words[sizeof(ParticleRecord) / 4];
    std::memcpy(words, &p, sizeof p);
    words[rng.below(std::size(words))] = kBad[rng.below(std::size(kBad))];
    std::memcpy(&p, words, sizeof p);
  }
}

Case random_case(Random& r) {
  Pcg32& rng = r.rng;
  uint32_t count = 0;
  switch (r.branch({{"few", 0.3}, {"usual", 0.3}, {"many", 0.33}, {"very_many", 0.07}})) {
    case 0:
      count = 1 + rng.below(40);
      break;
    case 1:
      count = 200 + rng.below(3000);
      break;
    case 2:
      count = 16500 + rng.below(8000);
      break;
    default:
      count = 100000 + rng.below(9000);
  }
  ParticleAtlas atlas = particle_atlas_of(count);
  switch (r.branch({{"room_for_all", 0.4}, {"room_for_some", 0.4}, {"odd_regions", 0.2}})) {
    case 0:
      break;
    case 1: {
      const uint32_t side = std::max(32u, atlas.side / 4);
      atlas = {side, {side / 4, side / 4, side / 2}};
      break;
    }
    default:
      atlas = {rng.below(1500), {rng.below(500), rng.below(500), rng.below(500)}};
  }
  std::vector<ParticleRecord> particles = puffs(rng, count);
  if (r.branch({{"sound", 0.75}, {"broken", 0.25}}) == 1) break_particles(particles, rng);
  const RectParams params = view(atlas, rng.range(100, 4000));
  std::vector<uint32_t> previous;
  switch (r.branch({{"no_previous", 0.25}, {"previous_kept", 0.45}, {"previous_garbage", 0.3}})) {
    case 0:
      break;
    case 1:
      previous = left_before(case_of(params, particles), rng, 0.7);
      break;
    default:
      for (uint32_t i = 0; i < count; ++i) previous.push_back(rng.next() >> rng.below(32));
  }
  return case_of(params, particles, previous);
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> cases;
  const auto particles = c.input<ParticleRecord>("particles");
  const auto previous = c.input<uint32_t>("previous");
  for (const size_t parts : {2u, 8u, 64u, 1024u})
    for (size_t k = 0; k < parts && particles.size() >= parts && cases.size() < 64; ++k) {
      const size_t from = particles.size() * k / parts, to = particles.size() * (k + 1) / parts;
      std::vector<ParticleRecord> some(particles.begin(), particles.end());
      std::vector<uint32_t> words(previous.begin(), previous.end());
      some.erase(some.begin() + static_cast<ptrdiff_t>(from), some.begin() + static_cast<ptrdiff_t>(to));
      words.erase(words.begin() + static_cast<ptrdiff_t>(from), words.begin() + static_cast<ptrdiff_t>(to));
      cases.push_back(case_of(c.params<RectParams>(), some, words));
      cases.back().name = c.name, cases.back().seed = c.seed;
    }
  return cases;
}

}  // namespace

Case typical(Extent e) {
  Pcg32 rng(0x9a17);
  const auto count = static_cast<uint32_t>(std::clamp<uint64_t>(pixel_count(e) / 1000, 1, kMostParticles));
  const auto particles = puffs(rng, count);
  const RectParams params = view(particle_atlas_of(count), e.width);
  return case_of(params, particles, left_before(case_of(params, particles), rng, 0.6));
}

Inputs inputs() {
  return {.random = random_case,
          .branches = {"few", "usual", "many", "very_many", "room_for_all", "room_for_some", "odd_regions", "sound",
                       "broken", "no_previous", "previous_kept", "previous_garbage"},
          .hard = hard_cases(),
          .smaller = smaller};
}

}  // namespace assay::particle_rects
