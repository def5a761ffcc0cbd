#include "harness/particle_scenes.h"

namespace assay {

using glm::dvec3;

ParticleRecord facing_particle(const dvec3& centre, double radius, double turn_rad) {
  const dvec3 normal = -glm::normalize(centre);
  const dvec3 other = std::fabs(normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 x = glm::normalize(glm::cross(other, normal)), y = glm::cross(normal, x);
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  return {vec3(centre), 0.5f, vec3((x * c + y * s) * radius), 0.2f, vec3((y * c - x * s) * radius), 1, vec3(1)};
}

ParticleRecord random_particle(Pcg32& rng, double nearest, double farthest) {
  const double z = nearest * std::pow(farthest / nearest, rng.unit());
  const dvec3 centre = {z * rng.range(-1.2, 1.2), z * rng.range(-1.2, 1.2), -z};
  ParticleRecord p = facing_particle(centre, z * std::exp2(rng.range(-9, 0)), rng.range(0, 6.28));
  if (rng.below(8) == 0) p.up *= 0.05f;
  if (rng.below(8) == 0) p.right += p.up * 0.3f + vec3(0, 0, static_cast<float>(rng.range(-0.5, 0.5) * z));
  p.opacity = static_cast<float>(rng.range(0.05, 1)),
  p.quality = rng.below(4) ? 1 : static_cast<float>(rng.range(0.2, 3));
  p.albedo = vec3(rng.range(0.1, 1), rng.range(0.1, 1), rng.range(0.1, 1));
  return p;
}

}  // namespace assay
