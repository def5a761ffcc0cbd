#include "kernels/particles/air.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "harness/half.h"
#include "harness/radiance_oracle.h"

namespace assay::particles {

using glm::dvec3;

dvec3 Air::ray(double x, double y) const {
  return dvec3(params.rays.corner) + dvec3(params.rays.across) * x + dvec3(params.rays.down) * y;
}
void Air::add(const ParticleRecord& p, uint32_t rect) {
  order.push_back(static_cast<uint32_t>(particles.size()));
  particles.push_back(p);
  rects.push_back(rect);
}

// A position is w (corner + x across + y down): the inverse gives w x, w y and w, and of these come clip coordinates.
void set_clip_rows(ParticlesParams& p, Extent e) {
  const glm::dmat3 back =
      glm::transpose(glm::inverse(glm::dmat3(dvec3(p.rays.across), dvec3(p.rays.down), dvec3(p.rays.corner))));
  p.clip_x = vec3(back[0] * (2.0 / e.width) - back[2]);
  p.clip_y = vec3(back[1] * (2.0 / e.height) - back[2]);
  p.clip_w = vec3(back[2]);
}

dvec3 turned(const dvec3& v, double a, double b) {
  const dvec3 y = {v.x, std::cos(b) * v.y - std::sin(b) * v.z, std::sin(b) * v.y + std::cos(b) * v.z};
  return {std::cos(a) * y.x + std::sin(a) * y.z, y.y, std::cos(a) * y.z - std::sin(a) * y.x};
}

Air air(Extent e, double wall_m) {
  const double down = static_cast<double>(e.height) / static_cast<double>(e.width);
  Air a = {.extent = e, .side = 128};
  ParticlesParams& p = a.params;
  p.rays = {vec3(-1, down, -1), vec3(2.0 / e.width, 0, 0), vec3(0, -2 * down / e.height, 0)};
  set_clip_rows(p, e);
  p.near_plane = 0.1f;
  p.ambient = vec3(0.02f, 0.03f, 0.04f);
  p.encoding = kLightR11G11B10;
  a.depth.assign(pixel_count(e), static_cast<float>(double{p.near_plane} / wall_m));
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x)
      a.radiance.emplace_back(0.1 + 0.02 * (x % 37), 0.2 + 0.03 * (y % 29), 0.05 + 0.01 * ((x + y) % 41), 1);
  Pcg32 rng(11);
  for (uint32_t i = 0; i < a.side * a.side; ++i)
    a.atlas.push_back(encoded({rng.range(0.7, 1.4), rng.range(0.3, 0.6), rng.range(1.4, 2.8)}, p.encoding));
  return a;
}

Case to_case(const std::string& name, const Air& a) {
  Case c = {.name = name, .extent = a.extent};
  ParticlesParams params = a.params;
  params.particles = static_cast<uint32_t>(a.particles.size());
  params.drawn = static_cast<uint32_t>(a.order.size());
  params.atlas_side = a.side;
  params.lights = static_cast<uint32_t>(a.lights.size());
  c.set_params(params);
  std::vector<uint16_t> halves;
  for (const vec4& t : a.radiance)
    for (int i = 0; i < 4; ++i) halves.push_back(nearest_half(t[i]));
  c.set_input("radiance", halves);
  c.set_input("depth", a.depth);
  c.set_input("particles", a.particles);
  c.set_input("order", a.order);
  c.set_input("rects", a.rects);
  set_atlas(c, params.encoding, a.atlas);
  c.set_input("lights", a.lights);
  return c;
}

ParticleRecord facing(const dvec3& centre, double radius) {
  return {.centre = vec3(centre),
          .opacity = 0.6f,
          .right = vec3(static_cast<float>(radius), 0, 0),
          .softness = 0.2f,
          .up = vec3(0, static_cast<float>(radius), 0),
          .quality = 1,
          .albedo = vec3(0.8f, 0.7f, 0.6f)};
}

uint32_t rect(uint32_t side, uint32_t column, uint32_t row) {
  const uint32_t size = side == 8 ? 1 : side == 16 ? 2 : 3;
  return column * side / 8 | (row * side / 8) << kRectYShift | size << kRectSizeShift;
}

uvec2 encoded(const dvec3& colour, uint32_t encoding) { return radiance::encoded(colour, encoding); }
void set_atlas(Case& c, uint32_t encoding, const std::vector<uvec2>& texels) {
  if (encoding == kLightRgba16) return c.set_input("atlas", texels);
  std::vector<uint32_t> words;
  for (const uvec2& t : texels) words.push_back(t.x);
  c.set_input("atlas", words);
}

void add_plume(Air& a, Pcg32& rng, uint32_t count, double nearest_m, double farthest_m, double radius_m) {
  std::vector<double> depths;
  for (uint32_t i = 0; i < count; ++i) depths.push_back(nearest_m * std::pow(farthest_m / nearest_m, rng.unit()));
  std::ranges::sort(depths, std::greater());
  for (const double depth : depths) {
    const dvec3 centre = a.ray(rng.range(-0.1, 1.1) * a.extent.width, rng.range(-0.1, 1.1) * a.extent.height) * depth;
    ParticleRecord p = facing(centre, 1);
    const dvec3 z = glm::normalize(centre), x = glm::normalize(glm::cross(z, dvec3(0, 1, 0.01))), y = glm::cross(x, z);
    const double radius = radius_m * rng.range(0.5, 1.5), turn = rng.range(0, 6.3), stretch = rng.range(1, 2.5);
    p.right = vec3((x * std::cos(turn) + y * std::sin(turn)) * radius * stretch);
    p.up = vec3((y * std::cos(turn) - x * std::sin(turn)) * radius);
    p.opacity = static_cast<float>(rng.range(0.05, 0.9));
    p.softness = rng.below(4) ? static_cast<float>(rng.range(0.01, 1)) : 0;
    p.albedo = vec3(rng.unit(), rng.unit(), rng.unit());
    const uint32_t side = 8u << rng.below(3), across = a.side / side;
    a.add(p, rect(side, rng.below(across), rng.below(across)));
  }
}

void add_lights(Air& a, Pcg32& rng, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    const double depth = rng.range(1, 8);
    LightRecord l = {};
    l.position = vec3(a.ray(rng.unit() * a.extent.width, rng.unit() * a.extent.height) * depth);
    l.range = static_cast<float>(rng.range(3, 15));
    l.colour = vec3(rng.range(1, 20), rng.range(1, 20), rng.range(1, 20));
    l.kind = rng.below(3);
    l.direction = vec3(glm::normalize(dvec3(rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1)) + 0.01));
    l.cone_scale = 5, l.cone_offset = -3;
    a.lights.push_back(l);
  }
}

}  // namespace assay::particles
