// Particles out of emitters, the same on every machine.
#include <cmath>

#include "harness/scene/noise.h"
#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

using builtin::random;

constexpr double kRise_mps = 0.6, kDrift_mps = 0.12, kDustLife_s = 9;
constexpr uint32_t kMostCount = 1u << 20;  // of one emitter; of a scene, what fits a storage buffer

struct Numbers {  // of one particle, each its own
  uint32_t particle, seed, next = 0;
  double unit() { return random(particle, next++, seed); }
  double signed_unit() { return 2 * unit() - 1; }
  glm::dvec3 in_box(const glm::dvec3& half) {
    const double x = signed_unit(), y = signed_unit(), z = signed_unit();
    return half * glm::dvec3(x, y, z);
  }
};

}  // namespace

std::string fault_of(const Emitter& e) {
  const auto finite = [](double v) { return std::abs(v) < 1e30; };
  for (int i = 0; i < 3; ++i) {
    if (!finite(e.position[i]) || !finite(e.half_extents[i]) || e.half_extents[i] < 0)
      return "its place is not finite, or half_extents are negative";
    if (!(e.colour[i] >= 0 && e.colour[i] <= 1)) return "its colour is not within 0 and 1";
  }
  if (e.count > kMostCount) return "it has more than 1048576 particles";
  if (!(e.radius > 0 && finite(e.radius))) return "its radius is not above 0";
  if (!(e.opacity >= 0 && e.opacity <= 1)) return "its opacity is not within 0 and 1";
  if (!(e.height > 0 && finite(e.height))) return "its height is not above 0";
  return {};
}

void add_particles(Scene& s, const Emitter& e) {
  const bool smoke = e.kind == EmitterKind::smoke;
  for (uint32_t i = 0; i < e.count; ++i) {
    Numbers n = {i, e.seed + 1};
    const glm::dvec3 begin = e.position + n.in_box(e.half_extents);
    Particle p = {.velocity = n.in_box(glm::dvec3(kDrift_mps)),
                  .radius = e.radius * static_cast<float>(0.7 + 0.6 * n.unit()),
                  .albedo = e.colour,
                  .opacity = e.opacity,
                  .softness = smoke ? e.radius : 0.02f};
    p.life_s = kDustLife_s * (0.7 + 0.6 * n.unit());
    if (smoke) {
      p.velocity.y = kRise_mps * (0.7 + 0.6 * n.unit());
      p.life_s = e.height / p.velocity.y;
    }
    p.age_s = p.life_s * n.unit();
    p.centre = begin + p.velocity * p.age_s;
    s.particles.push_back(p);
  }
}

}  // namespace assay::scene
