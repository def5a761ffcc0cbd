// Light records of a view.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

constexpr double kLeastCone = 0.001;  // of cos(inner) - cos(outer), KHR_lights_punctual's guard against dividing by 0

LightRecord record_of(const Light& light, const glm::dvec3& eye) {
  LightRecord r = {.position = vec3(light.position - eye),
                   .range = light.range,
                   .colour = light.colour * light.intensity,
                   .kind = light.kind == LightKind::directional ? kLightDirectional
                           : light.kind == LightKind::point     ? kLightPoint
                                                                : kLightSpot,
                   .direction = light.direction,
                   .cone_scale = 0,
                   .cone_offset = 1};
  if (light.kind == LightKind::spot) {
    const double inner = std::cos(double{light.inner_rad}), outer = std::cos(double{light.outer_rad});
    const double scale = 1 / std::max(kLeastCone, inner - outer);
    r.cone_scale = static_cast<float>(scale);
    r.cone_offset = static_cast<float>(-outer * scale);
  }
  return r;
}

// Whether the sphere of its range lies wholly beyond one plane of the frustum. The slack, 10^-4 of the coordinates, is
// far above what a position rebuilt from a float depth is off by.
bool out_of_reach(const Light& light, const Camera& camera, const ClipRows& rows) {
  if (light.kind == LightKind::directional || !(light.range > 0)) return false;
  const glm::dvec3 at = light.position - camera.eye, x(rows.x), y(rows.y), w(rows.w);
  const double reach = light.range + 1e-4 * (length(at) + light.range);
  const glm::dvec3 outward[4] = {x - w, -x - w, y - w, -y - w};
  return std::any_of(outward, outward + 4, [&](const glm::dvec3& n) { return dot(normalize(n), at) > reach; }) ||
         camera.near_plane - dot(w, at) > reach;
}

// For a scene that has none: over the viewer's right shoulder, so that what is seen is lit and its shape is told. At pi
// lux a white Lambert surface that faces the light has the radiance 1.
Light default_light(const Camera& camera) {
  Light light;
  light.kind = LightKind::directional;
  light.direction = glm::vec3(camera.orientation * normalize(glm::dvec3(-0.4, -0.6, -1)));
  light.intensity = 3.14159265f;
  return light;
}

}  // namespace

std::string fault_of(const Light& light) {
  const auto finite = [](float v) { return std::abs(v) < 1e30f; };
  if (!finite(light.intensity) || light.intensity < 0) return "its intensity is negative or not finite";
  if (!finite(light.range) || light.range < 0) return "its range is negative or not finite";
  for (int c = 0; c < 3; ++c)
    if (!finite(light.colour[c]) || light.colour[c] < 0) return "its colour is negative or not finite";
  if (light.kind != LightKind::spot) return {};
  constexpr float kWidest = 1.5707965f;  // pi/2, and what writing it in seven digits adds
  if (!(light.inner_rad >= 0 && light.inner_rad <= light.outer_rad && light.outer_rad <= kWidest))
    return "its cone's angles do not satisfy 0 <= inner <= outer <= pi/2";
  return {};
}

std::vector<Light> lights_of(const Scene& scene, const Camera& camera) {
  return scene.lights.empty() ? std::vector<Light>{default_light(camera)} : scene.lights;
}

void append_lights(const Scene& scene, const Camera& camera, const ClipRows& rows, Gathered& to) {
  const std::vector<Light> lights = lights_of(scene, camera);
  for (uint32_t i = 0; i < lights.size(); ++i) {
    if (out_of_reach(lights[i], camera, rows)) continue;
    to.lights.push_back(record_of(lights[i], camera.eye));
    to.light_source.push_back(scene.lights.empty() ? kNone : i);
  }
  if (scene.lights.empty())
    to.notes.emplace_back(
        "the scene has no light: a directional one of 3.14 lux shines from over the viewer's shoulder");
  if (const size_t culled = lights.size() - to.lights.size())
    to.notes.push_back(fmt::format("{} of {} lights do not reach the view and are culled", culled, lights.size()));
}

}  // namespace assay::scene
