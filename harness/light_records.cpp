#include "harness/light_records.h"

#include <algorithm>

namespace assay {

using glm::dvec3;

LightRecord directional(const dvec3& direction, const vec3& colour) {
  return {vec3(0), 0, colour, kLightDirectional, vec3(glm::normalize(direction)), 0, 1};
}
LightRecord point(const dvec3& position, double range, const vec3& colour) {
  return {vec3(position), static_cast<float>(range), colour, kLightPoint, vec3(0, -1, 0), 0, 1};
}
LightRecord spot(const dvec3& position, const dvec3& direction, double range, double inner_rad, double outer_rad,
                 const vec3& colour) {
  // 0 at the outer angle and 1 at the inner one, as KHR_lights_punctual scales it.
  const double scale = 1 / std::max(0.001, std::cos(inner_rad) - std::cos(outer_rad));
  return {vec3(position),
          static_cast<float>(range),
          colour,
          kLightSpot,
          vec3(glm::normalize(direction)),
          static_cast<float>(scale),
          static_cast<float>(-std::cos(outer_rad) * scale)};
}

LightRecord random_light(Pcg32& rng, const dvec3& target, double reach) {
  const auto around = [&rng](double r) { return dvec3(rng.range(-r, r), rng.range(-r, r), rng.range(-r, r)); };
  const dvec3 position = target * rng.range(0.7, 1) + around(0.5 * reach);
  const double power = std::exp2(rng.range(-2, 4)) * reach * reach;
  const vec3 colour = vec3(power * rng.range(0.3, 1), power * rng.range(0.3, 1), power * rng.range(0.3, 1));
  const uint32_t kind = rng.below(10);
  if (kind == 0) return directional(around(1) + dvec3(0, 0, -1), colour * static_cast<float>(0.1 / (reach * reach)));
  if (kind < 6) return point(position, rng.below(4) ? reach * rng.range(0.3, 3) : 0, colour);
  return spot(position, target - position + around(0.2 * reach), rng.below(4) ? reach * rng.range(0.5, 3) : 0,
              rng.range(0.05, 0.5), rng.range(0.5, 1.3), colour);
}

}  // namespace assay
