// Where things and the viewer are in a frame of a sequence.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

double swing(uint32_t frame, double period_s) {
  return std::sin(std::fmod(frame * kFrame_s / period_s, 1.0) * glm::two_pi<double>());
}

// The viewer turns 10 degrees a second at first and walks 1.4 m a second where the near plane is the usual 0.1 m: files
// of small things have a nearer one.
constexpr double kLook_rad = 0.1745, kLookPeriod_s = 6.283;
constexpr double kWalk_nearPlanes = 10, kWalkPeriod_s = 4.488;

}  // namespace

void move_to_frame(uint32_t frame, const Scene& from, Scene& to) {
  for (size_t i = 0; i < from.instances.size(); ++i) {
    const glm::dmat4& rest = from.instances[i].to_world;
    const Motion& motion = from.instances[i].motion;
    const double s = swing(frame, motion.period_s);
    glm::dmat4& moved = to.instances[i].to_world;
    moved = rest;
    if (s == 0) continue;
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1), motion.turn_rad * s, glm::dvec3(0, 1, 0)));
    for (int column = 0; column < 3; ++column) moved[column] = glm::dvec4(turn * glm::dvec3(rest[column]), 0);
    moved[3] += glm::dvec4(motion.reach * s, 0);
  }
  for (size_t i = 0; i < from.lights.size(); ++i) {
    const Light& rest = from.lights[i];
    Light& moved = to.lights[i];
    const double s = swing(frame, rest.motion.period_s);
    moved.position = rest.position + rest.motion.reach * s;
    moved.direction = rest.direction;
    if (rest.motion.turn_rad != 0)
      moved.direction = glm::vec3(glm::rotate(glm::dmat4(1), rest.motion.turn_rad * s, glm::dvec3(0, 1, 0)) *
                                  glm::dvec4(rest.direction, 0));
  }
  for (size_t i = 0; i < from.particles.size(); ++i) {
    const Particle& rest = from.particles[i];
    if (!(rest.life_s > 0)) continue;
    to.particles[i].age_s = std::fmod(rest.age_s + frame * kFrame_s, rest.life_s);
    to.particles[i].centre = rest.centre + rest.velocity * (to.particles[i].age_s - rest.age_s);
  }
}

Camera camera_in_frame(const Camera& from, uint32_t frame) {
  if (frame == 0) return from;
  Camera to = from;
  const glm::dvec3 forward = from.orientation * glm::dvec3(0, 0, -1);
  to.eye += forward * (kWalk_nearPlanes * from.near_plane * swing(frame, kWalkPeriod_s));
  to.orientation = glm::angleAxis(kLook_rad * swing(frame, kLookPeriod_s), glm::dvec3(0, 1, 0)) * from.orientation;
  return to;
}

}  // namespace assay::scene
