#include "harness/shadow_maps.h"

#include <algorithm>
#include <array>
#include <glm/matrix.hpp>

namespace assay::shadowing {

using glm::dvec3;
using glm::dvec4;

namespace {

// The axes of a view that looks along one: right, down, along.
struct Axes {
  dvec3 right, down, along;
};
Axes axes_along(const dvec3& direction) {
  const dvec3 along = glm::normalize(direction);
  const dvec3 up = std::fabs(along.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 right = glm::normalize(glm::cross(along, up));
  return {right, glm::cross(along, right), along};
}
constexpr std::array<Axes, kCubeFaces> kFaces = {{{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
                                                  {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                                  {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                  {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                                  {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                                  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}};

vec4 row(const dvec3& axis, const dvec3& origin, double scale, double offset = 0) {
  return vec4(dvec4(axis * scale, offset - scale * glm::dot(axis, origin)));
}

// kernels/shadow_lookup/README.md, Bias: 24u of the farthest point's distance and the light's, 16u of the quotients.
float bias_of(double reach, const dvec3& origin, double scale, double least_w) {
  return static_cast<float>((24 * scale * (reach + glm::length(origin)) / least_w + 16) * kUnitRoundoff);
}

ShadowView perspective(const ShadowTile& tile, const dvec3& position, const Axes& a, double cotangent, double near,
                       double reach) {
  return {row(a.right, position, cotangent),
          row(a.down, position, cotangent),
          vec4(0, 0, 0, near),
          row(a.along, position, 1),
          tile,
          bias_of(reach, position, std::max(cotangent, 1.0), near)};
}

dvec3 turn(const vec4& r) { return {r.x, r.y, r.z}; }
double at(const vec4& r, const dvec3& p) { return glm::dot(turn(r), p) + double{r.w}; }

}  // namespace

uint32_t Atlas::add_spot(const ShadowTile& tile, const dvec3& position, const dvec3& direction, double half_rad,
                         double near, double reach) {
  views.push_back(perspective(tile, position, axes_along(direction), 1 / std::tan(half_rad), near, reach));
  return static_cast<uint32_t>(views.size()) - 1;
}

uint32_t Atlas::add_cube(const ShadowTile& first, const dvec3& position, double near, double reach) {
  ShadowTile tile = first;
  for (const Axes& face : kFaces) {
    views.push_back(perspective(tile, position, face, 1, near, reach));
    tile.x += tile.side;
  }
  return static_cast<uint32_t>(views.size()) - kCubeFaces;
}

uint32_t Atlas::add_cascade(const ShadowTile& tile, const dvec3& centre, const dvec3& direction, double half_width,
                            double half_depth, double reach) {
  const Axes a = axes_along(direction);
  const double scale = 1 / half_width, depth = -0.5 / half_depth;
  views.push_back({row(a.right, centre, scale), row(a.down, centre, scale), row(a.along, centre, depth, 0.5),
                   vec4(0, 0, 0, 1), tile, bias_of(reach, centre, std::max(scale, -depth), 1)});
  return static_cast<uint32_t>(views.size()) - 1;
}

std::optional<dvec3> point_on(const ShadowView& v, double x, double y, const Caster& c) {
  // Three planes meet: those of x, of y and the caster's.
  const dvec3 across = turn(v.clip_x) - x * turn(v.clip_w), down = turn(v.clip_y) - y * turn(v.clip_w);
  const glm::dmat3 planes = glm::transpose(glm::dmat3(across, down, c.normal));
  if (std::fabs(glm::determinant(planes)) < 1e-12 * glm::length(across) * glm::length(down)) return {};
  const dvec3 p =
      glm::inverse(planes) * dvec3(x * double{v.clip_w.w} - double{v.clip_x.w},
                                   y * double{v.clip_w.w} - double{v.clip_y.w}, glm::dot(c.normal, c.centre));
  const double w = at(v.clip_w, p), z = at(v.clip_z, p);
  if (!(w > 0 && z > 0 && z <= w) || glm::length(p - c.centre) > c.radius) return {};
  return p;
}

void Atlas::add_light(const ShadowTile& first, LightRecord& light, const dvec3& seen, Pcg32& rng) {
  const dvec3 position = dvec3(light.position), direction = dvec3(light.direction);
  const double reach = glm::length(seen) + 10;
  light.first_view = static_cast<uint32_t>(views.size());
  if (light.kind == kLightDirectional)
    for (uint32_t k = 0; k < 3; ++k)
      add_cascade({first.x + k * first.side, first.y, first.side}, seen, direction, std::exp2(k), 40, reach);
  else if (light.kind == kLightPoint)
    add_cube(first, position, 0.05, reach);
  else
    add_spot(first, position, direction, rng.range(0.5, 1.3), 0.05, reach);
  light.views = static_cast<uint32_t>(views.size()) - light.first_view;
  const dvec3 from = light.kind == kLightDirectional ? seen - 5.0 * direction : position;
  for (uint32_t k = 0; k < 3; ++k) {
    const dvec3 centre = from + rng.range(0.2, 0.95) * (seen - from);
    const dvec3 normal = {rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1)};
    for (uint32_t view = 0; view < light.views; ++view)
      draw(light.first_view + view, {centre, normal, rng.range(0.05, 0.5) * glm::length(seen - from)});
  }
}

void Atlas::draw(uint32_t view, const Caster& c) {
  const ShadowView& v = views[view];
  for (uint32_t j = 0; j < v.tile.side; ++j)
    for (uint32_t i = 0; i < v.tile.side; ++i) {
      const auto p = point_on(v, (2 * i + 1.0) / v.tile.side - 1, (2 * j + 1.0) / v.tile.side - 1, c);
      if (!p) continue;
      float& depth = depths[size_t{v.tile.y + j} * extent.width + v.tile.x + i];
      depth = std::max(depth, static_cast<float>(at(v.clip_z, *p) / at(v.clip_w, *p)));
    }
}

void Atlas::fill(const ShadowTile& t, float depth) {
  for (uint32_t j = 0; j < t.side; ++j)
    for (uint32_t i = 0; i < t.side; ++i) depths[size_t{t.y + j} * extent.width + t.x + i] = depth;
}

}  // namespace assay::shadowing
