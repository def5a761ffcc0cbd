#include "kernels/particles/quads.h"

#include <algorithm>
#include <cmath>

namespace assay::particles {

using glm::dvec2;
using glm::dvec3;

namespace {

constexpr double u = kUnitRoundoff;

bool all_within(const vec3& v, double most) {
  return std::fabs(v.x) <= most && std::fabs(v.y) <= most && std::fabs(v.z) <= most;
}
double largest(const vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
double size_of(const ParticleRecord& p) {
  return glm::length(dvec3(p.centre)) + glm::length(dvec3(p.right)) + glm::length(dvec3(p.up));
}

// a / b of a divisor of either sign that is not 0.
Interval quotient(Interval a, Interval b) { return b.low > 0 ? a / b : -a / -b; }

dvec3 exact_ray(const ParticlesParams& p, double x, double y) {
  return dvec3(p.rays.corner) + dvec3(p.rays.across) * x + dvec3(p.rays.down) * y;
}

// Of a point in pixels, without error; none where the ray misses the plane.
std::optional<dvec2> exact_place(const View& v, const ParticleRecord& p, double x, double y) {
  const dvec3 ray = exact_ray(v.params, x, y), c(p.centre), right(p.right), up(p.up);
  const double across = glm::dot(cross(right, up), ray);
  if (across == 0) return {};
  return dvec2(glm::dot(cross(up, c), ray), glm::dot(cross(c, right), ray)) / across;
}

struct Corner {
  dvec2 pixel;
  double moved = 0;
};
// Rows of clip coordinates are sums of three products of a sum of three: 8u of the magnitudes, over w; the viewport's
// product and sum 3u; the grid's half step.
Corner corner_of(const View& v, const ParticleRecord& p, const dvec2& at) {
  const dvec3 point = position(p, at);
  const double w = glm::dot(dvec3(v.params.clip_w), point);
  const dvec2 clip = {glm::dot(dvec3(v.params.clip_x), point), glm::dot(dvec3(v.params.clip_y), point)};
  const dvec2 size = {v.extent.width, v.extent.height}, ndc = clip / w;
  const double row = std::max(glm::length(dvec3(v.params.clip_x)), glm::length(dvec3(v.params.clip_y))),
               clip_error = 8 * u * size_of(p) * row,
               w_error = 8 * u * size_of(p) * glm::length(dvec3(v.params.clip_w));
  const double far = std::max(std::fabs(ndc.x), std::fabs(ndc.y)), half = 0.5 * std::max(size.x, size.y);
  return {(ndc * 0.5 + 0.5) * size,
          half * ((clip_error + far * w_error) / std::max(w - w_error, 1e-300) + 8 * u * (far + 1)) + 1 / v.grid};
}

const dvec2 kCornersAt[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

void bound_pixels(const View& v, const std::array<Corner, 4>& corners, Quad& q) {
  dvec2 low(1e300), high(-1e300);
  for (const Corner& c : corners) {
    q.moved = std::max(q.moved, c.moved);
    low = min(low, c.pixel), high = max(high, c.pixel);
  }
  const dvec2 size = {v.extent.width, v.extent.height};
  q.clipped = low.x < 0 || low.y < 0 || high.x > size.x || high.y > size.y;
  const dvec2 first = glm::clamp(low - q.moved - 1.0, dvec2(0), size),
              end = glm::clamp(high + q.moved + 1.0, dvec2(0), size);
  q.x_first = static_cast<uint32_t>(first.x), q.y_first = static_cast<uint32_t>(first.y);
  q.x_end = static_cast<uint32_t>(std::ceil(end.x)), q.y_end = static_cast<uint32_t>(std::ceil(end.y));
}

}  // namespace

bool is_drawn(const ParticleRecord& p) {
  return all_within(p.centre, kFarthest) && all_within(p.right, kFarthest) && all_within(p.up, kFarthest) &&
         largest(p.right) >= kSmallest && largest(p.up) >= kSmallest && all_within(p.albedo, kGreatestRadiance) &&
         p.opacity >= kLeastShown && p.quality >= kLeastShown && std::fabs(p.softness) <= kFarthest;
}

dvec3 position(const ParticleRecord& p, const dvec2& at) {
  return dvec3(p.centre) + dvec3(p.right) * at.x + dvec3(p.up) * at.y;
}

Ball ray_of(const ParticlesParams& p, uint32_t x, uint32_t y) {
  const dvec3 corner(p.rays.corner), across = dvec3(p.rays.across) * (x + 0.5), down = dvec3(p.rays.down) * (y + 0.5);
  return {corner + across + down, 3 * u * glm::length(abs(corner) + abs(across) + abs(down))};
}

std::optional<Quad> quad_of(const View& v, const ParticleRecord& p) {
  if (!is_drawn(p)) return {};
  Quad q = {.record = p, .normal = cross(Ball{dvec3(p.right), 0}, Ball{dvec3(p.up), 0})};
  // The shader's own margin is 2e-6 of these coordinates; twice that makes sure.
  const double slack = 4e-6 * (largest(p.centre) + largest(p.right) + largest(p.up));
  std::array<Corner, 4> corners;
  double nearest = 1e300, farthest = -1e300;
  for (size_t i = 0; i < 4; ++i) {
    const double w = glm::dot(dvec3(v.params.clip_w), position(p, kCornersAt[i]));
    nearest = std::min(nearest, w), farthest = std::max(farthest, w);
  }
  if (farthest < double{v.params.near_plane} - slack) return {};
  // Below the near plane the shader's margin makes the screen of it for sure; within twice the margin it may.
  q.whole_screen = nearest < v.params.near_plane;
  if (!q.whole_screen) {
    for (size_t i = 0; i < 4; ++i) corners[i] = corner_of(v, p, kCornersAt[i]);
    bound_pixels(v, corners, q);
  }
  if (nearest < double{v.params.near_plane} + slack) {
    q.x_first = q.y_first = 0;
    q.x_end = v.extent.width, q.y_end = v.extent.height;
  }
  return q;
}

Place place_of(const View& v, const Quad& q, uint32_t x, uint32_t y) {
  const Ball ray = ray_of(v.params, x, y), c = {dvec3(q.record.centre), 0};
  const Interval across = dot(q.normal, ray);
  if (across.low <= 0 && across.high >= 0) return {};
  const Ball row_x = cross({dvec3(q.record.up), 0}, c), row_y = cross(c, {dvec3(q.record.right), 0});
  return {.x = quotient(dot(row_x, ray), across),
          .y = quotient(dot(row_y, ray), across),
          .depth = quotient(dot(c, q.normal), across),
          .known = true};
}

Times times_covered(const View& v, const Quad& q, uint32_t x, uint32_t y) {
  if (q.whole_screen) return {};
  bool inside = true, above = false, below = false;
  for (const dvec2& by : kCornersAt) {
    const auto at = exact_place(v, q.record, x + 0.5 + by.x * q.moved, y + 0.5 + by.y * q.moved);
    if (!at) return {0, q.clipped ? 2 : 1};
    inside = inside && std::fabs(at->x) < 1 && std::fabs(at->y) < 1;
    (at->x > at->y ? above : below) = true;
  }
  const bool on_diagonal = above && below && q.clipped;
  return {inside && !on_diagonal ? 1 : 0, on_diagonal ? 2 : 1};
}

}  // namespace assay::particles
