#include "harness/scene/shadow_views.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "harness/scene/gather.h"

namespace assay::scene {
namespace {

// The widest filter reaches 4 texels past a point, 7 taps' half and one for the bilinear share.
constexpr double kFilterReach_texels = 4;
constexpr uint32_t kMostSide = 1024;  // of a spot or a point light
constexpr double kFirstCascade_m = 3, kMostCascades_m = 100;
constexpr double kSnapShare = 1.0 / 16;  // of a cascade's side: its middle moves in steps of that, and is kept between

double reach_of(const Light& light, const Bounds& bounds) {
  return light.range > 0 ? light.range : length(bounds.highest - bounds.lowest);
}

double cascades_end(const Camera& camera, const Bounds& bounds) {
  double farthest = kFirstCascade_m;
  for (int i = 0; i < 8; ++i)
    farthest = std::max(farthest, distance(camera.eye, glm::dvec3(i & 1 ? bounds.highest.x : bounds.lowest.x,
                                                                  i & 2 ? bounds.highest.y : bounds.lowest.y,
                                                                  i & 4 ? bounds.highest.z : bounds.lowest.z)));
  // In steps of the square root of 2, so that a step of the viewer's does not change every cascade.
  return std::min(kMostCascades_m, std::exp2(std::ceil(2 * std::log2(farthest)) / 2));
}

// Each reaches about three times as far as the one before.
uint32_t cascades_of(double end) {
  const double steps = std::ceil(std::log(end / kFirstCascade_m) / std::log(3.0));
  return static_cast<uint32_t>(std::clamp(1 + steps, 1.0, double{kMostCascades}));
}
double cascade_end(double end, uint32_t cascade, uint32_t count) {
  if (count == 1) return end;
  return kFirstCascade_m * std::pow(end / kFirstCascade_m, cascade / (count - 1.0));
}

struct Axes {
  glm::dvec3 right, up, forward;
};
Axes axes_of(const glm::dvec3& direction) {
  const glm::dvec3 forward = normalize(direction);
  const glm::dvec3 aside = std::abs(forward.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = normalize(cross(forward, aside));
  return {right, cross(right, forward), forward};
}

glm::dvec4 row_about(const glm::dvec3& axis, const glm::dvec3& origin) { return {axis, -dot(axis, origin)}; }

// What a caster's clip coordinates are off by, metres: four products and sums in floats of what a mesh's positions are
// away from the world's origin, under 16 u of that in all.
double caster_error(const Bounds& bounds) {
  return kPositionSlack / 4 * std::max(length(bounds.lowest), length(bounds.highest));
}
// And a position rebuilt from a depth: of its distance from the viewer, and of the light's from what it lights, as rows
// relative to the viewer are rounded too.
double position_error(const Light& light, const Camera& camera, double reach) {
  return kPositionSlack * (distance(light.position, camera.eye) + 2 * reach);
}

LightView perspective(const Light& light, const glm::dvec3& direction, double tangent, const Camera& camera,
                      const Bounds& bounds, double reach) {
  const double near_plane = std::clamp(reach * 0.005, 0.01, 0.1);
  const Axes a = axes_of(direction);
  // Bias is of w: what is nearer to the light than a twentieth of its reach may have a little less than it needs.
  return {
      .x = row_about(a.right / tangent, light.position),
      .y = row_about(-a.up / tangent, light.position),
      .z = {0, 0, 0, near_plane},
      .w = row_about(a.forward, light.position),
      .farthest = light.range > 0 ? light.range : 1e300,
      .bias = (position_error(light, camera, reach) + caster_error(bounds)) / (0.05 * reach * std::min(1.0, tangent))};
}

// Wider than the picture by what the filter reaches past its rim.
double widened(double tangent, uint32_t side) { return tangent * side / (side - 2 * kFilterReach_texels); }

// A sphere about what the viewer sees between two distances, so that turning changes nothing; its middle in steps.
LightView cascade(const Light& light, const Camera& camera, Extent extent, const Bounds& bounds, double from, double to,
                  uint32_t side) {
  const double tangent = std::tan(camera.vertical_fov_rad / 2),
               aspect = static_cast<double>(extent.width) / extent.height;
  const double middle = (from + to) / 2;
  const double radius = std::hypot(to - middle, to * tangent * std::hypot(1, aspect));
  const double half = radius / (1 - kSnapShare - 2 * kFilterReach_texels / side);
  const Axes a = axes_of(glm::dvec3(light.direction));
  const glm::dvec3 centre = camera.eye + camera.orientation * glm::dvec3(0, 0, -middle);
  const double step = 2 * half * kSnapShare;
  const auto snapped = [&](const glm::dvec3& axis) { return std::round(dot(axis, centre) / step) * step; };
  double lowest = 1e300, highest = -1e300;
  for (int i = 0; i < 8; ++i) {
    const double along = dot(
        a.forward, glm::dvec3(i & 1 ? bounds.highest.x : bounds.lowest.x, i & 2 ? bounds.highest.y : bounds.lowest.y,
                              i & 4 ? bounds.highest.z : bounds.lowest.z));
    lowest = std::min(lowest, along), highest = std::max(highest, along);
  }
  // Outward to a whole step, so that what moves at the scene's rim does not change every depth.
  const double quantum = std::exp2(std::floor(std::log2(std::max(highest - lowest, 1e-3)))) / 8;
  lowest = (std::floor(lowest / quantum) - 1) * quantum, highest = (std::ceil(highest / quantum) + 1) * quantum;
  const double depth = highest - lowest;
  return {
      .x = glm::dvec4(a.right, -snapped(a.right)) / half,
      .y = glm::dvec4(-a.up, snapped(a.up)) / half,
      .z = {-a.forward / depth, highest / depth},
      .w = {0, 0, 0, 1},
      .farthest = 1e300,
      .bias = (kPositionSlack * (to * std::hypot(1, tangent * std::hypot(1, aspect)) + depth) + caster_error(bounds)) /
              std::min(half, depth)};
}

}  // namespace

std::optional<TileWish> wish_of(const Light& light, uint32_t number, const Camera& camera, Extent extent,
                                const Bounds& bounds) {
  if (!light.casts_shadows) return {};
  const double pixels = extent.height / (2 * std::tan(camera.vertical_fov_rad / 2));  // of a metre at one metre
  if (light.kind == LightKind::directional) {
    const uint32_t side = std::clamp(std::bit_ceil(std::max(extent.height, 1u)), 256u, 2 * kMostSide);
    return TileWish{number, cascades_of(cascades_end(camera, bounds)), side, 1e300};
  }
  const double reach = reach_of(light, bounds), away = distance(light.position, camera.eye);
  // Pixels across of what it reaches; a viewer within sees what is half as far away as its rim.
  const double across = 2 * reach * pixels / std::max(away, reach / 2);
  const double side = light.kind == LightKind::spot ? across / 2 : across / 4;
  return TileWish{number, light.kind == LightKind::spot ? 1 : kCubeFaces,
                  std::bit_ceil(static_cast<uint32_t>(std::clamp(side, double{kLeastTile}, double{kMostSide}))),
                  across};
}

std::vector<LightView> views_of(const Light& light, const Camera& camera, Extent extent, const Bounds& bounds,
                                uint32_t side) {
  std::vector<LightView> views;
  const double reach = reach_of(light, bounds);
  switch (light.kind) {
    case LightKind::spot: {
      const double half = std::min(double{light.outer_rad}, kWidestSpot_rad);
      views.push_back(perspective(light, glm::dvec3(light.direction), widened(std::max(std::tan(half), 1e-3), side),
                                  camera, bounds, reach));
      break;
    }
    case LightKind::point:
      for (uint32_t face = 0; face < kCubeFaces; ++face) {
        glm::dvec3 direction(0);
        direction[face / 2] = face % 2 ? -1 : 1;
        views.push_back(perspective(light, direction, widened(1, side), camera, bounds, reach));
      }
      break;
    case LightKind::directional: {
      const double end = cascades_end(camera, bounds);
      const uint32_t count = cascades_of(end);
      for (uint32_t i = 0; i < count; ++i)
        views.push_back(cascade(light, camera, extent, bounds, i ? cascade_end(end, i - 1, count) : camera.near_plane,
                                cascade_end(end, i, count), side));
      break;
    }
  }
  return views;
}

}  // namespace assay::scene
