// Particle records of a view, and the order in which they are drawn.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

constexpr double kShutter_s = 0.05;  // how long a time of its way a particle is drawn out over

// Of its life: opacity as it fades in and out, radius as it spreads.
struct Aged {
  double opacity = 1, radius = 1;
};
Aged aged(const Particle& p) {
  if (!(p.life_s > 0)) return {};
  const double share = std::clamp(p.age_s / p.life_s, 0.0, 1.0);
  return {4 * share * (1 - share), 0.5 + share};
}

// Axes across the line of sight; the first along the velocity as it is seen, and longer by half of the way.
ParticleRecord record_of(const Particle& p, const Camera& camera) {
  const glm::dvec3 centre = p.centre - camera.eye, camera_right = camera.orientation * glm::dvec3(1, 0, 0),
                   camera_up = camera.orientation * glm::dvec3(0, 1, 0);
  const double distance = length(centre);
  const glm::dvec3 away = distance > 1e-9 ? centre / distance : camera.orientation * glm::dvec3(0, 0, -1);
  const glm::dvec3 seen = p.velocity - away * dot(p.velocity, away);
  const double speed = length(seen);
  // What is nearly along the line of sight has no direction across it: the other axis of the camera has.
  const glm::dvec3 level = std::abs(dot(away, camera_right)) < 0.9 ? camera_right : camera_up;
  const glm::dvec3 along = speed > 1e-6 ? seen / speed : normalize(level - away * dot(level, away));
  const Aged a = aged(p);
  const double radius = p.radius * a.radius;
  return {.centre = vec3(centre),
          .opacity = static_cast<float>(p.opacity * a.opacity),
          .right = vec3(along * (radius + speed * kShutter_s / 2)),
          .softness = p.softness,
          .up = vec3(normalize(cross(along, away)) * radius),
          .quality = p.quality,
          .albedo = p.albedo};
}

// Whether the sphere about it lies wholly beyond a plane of the frustum, or it has nothing to show.
bool is_seen(const ParticleRecord& p, const Camera& camera, const ClipRows& rows) {
  if (!(p.opacity > 0 && p.quality > 0)) return false;
  const glm::dvec3 at(p.centre), x(rows.x), y(rows.y), w(rows.w);
  const double size = std::hypot(length(glm::dvec3(p.right)), length(glm::dvec3(p.up))),
               reach = size + 1e-4 * (length(at) + size);
  const glm::dvec3 outward[4] = {x - w, -x - w, y - w, -y - w};
  return dot(w, at) + reach > camera.near_plane &&
         std::none_of(outward, outward + 4, [&](const glm::dvec3& n) { return dot(normalize(n), at) > reach; });
}

}  // namespace

void append_particles(const Scene& scene, const Camera& camera, const ClipRows& rows, Gathered& to) {
  std::vector<double> depths;
  for (const Particle& p : scene.particles) {
    const ParticleRecord record = record_of(p, camera);
    const auto number = static_cast<uint32_t>(to.particles.size());
    to.particles.push_back(record);
    depths.push_back(dot(glm::dvec3(rows.w), glm::dvec3(record.centre)));
    if (is_seen(record, camera, rows)) to.particle_order.push_back(number);
  }
  std::stable_sort(to.particle_order.begin(), to.particle_order.end(),
                   [&](uint32_t a, uint32_t b) { return depths[a] > depths[b]; });
  if (to.particles.empty()) return;
  if (const size_t unseen = to.particles.size() - to.particle_order.size())
    to.notes.push_back(fmt::format("{} of {} particles are not in view", unseen, to.particles.size()));
}

}  // namespace assay::scene
