#include "kernels/shadow_atlas/inputs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/raster/smaller.h"
#include "kernels/shadow_atlas/builder.h"

namespace assay::shadow_atlas {

using namespace raster;

namespace {

double log_range(Pcg32& rng, double low, double high) { return low * std::pow(high / low, rng.unit()); }

// Shapes in a tile's own coordinates.
struct Shapes {
  const LightView& light;
  Pcg32& rng;
  double side;  // texels
  double distance;

  double depth() const { return distance * rng.range(0.9, 1.1); }
  vec2 uv() const { return vec2(rng.range(-1, 2), rng.range(-1, 2)); }
  // Mostly in the tile, a third of the time up to a tile beside it.
  double somewhere() const { return rng.unit() < 0.67 ? rng.unit() : rng.range(-1, 2); }

  Mesh soup(uint32_t count, double low, double high) const {  // triangles of about so many texels
    Mesh m;
    for (uint32_t i = 0; i < count; ++i) {
      const double x = somewhere(), y = somewhere(), size = log_range(rng, low, high) / side;
      for (uint32_t k = 0; k < 3; ++k)
        m.indices.push_back(
            add_vertex(m, light.at(x + rng.range(-size, size), y + rng.range(-size, size), depth()), uv()));
    }
    return m;
  }
  Mesh grid() const {
    Mesh m;
    const double x = somewhere(), y = somewhere(), cell = log_range(rng, 0.7, 40) / side, slant = rng.range(-0.5, 0.5);
    const uint32_t columns = 1 + rng.below(12), rows = 1 + rng.below(12);
    add_grid(m, columns, rows, [&](float s, float t) {
      return light.at(x + cell * columns * (s + slant * t), y - cell * rows * (t - slant * s),
                      distance * (1 + 0.3 * s - 0.2 * t));
    });
    return m;
  }
  // From before the near plane to behind it, of suns also past the far plane.
  Mesh crossing(uint32_t count) const {
    Mesh m;
    for (uint32_t i = 0; i < 3 * count; ++i) {
      if (light.is_sun) {
        m.indices.push_back(add_vertex(
            m, light.at(rng.range(-1, 2), rng.range(-1, 2), rng.range(2 * light.first - light.last, 2 * light.last)),
            uv()));
        continue;
      }
      const double z = rng.unit() < 0.5 ? log_range(rng, 0.2, 20) : -log_range(rng, 0.01, 20);
      m.indices.push_back(add_vertex(m, vec3(rng.range(-3, 3), rng.range(-3, 3), -z), uv()));
    }
    return m;
  }
};

// Vertices on the sub-texel grid and at exact depths: coverage and depth are exact.
Mesh on_grid(Pcg32& rng, uint32_t side) {
  Mesh m;
  const double step = 1 << rng.below(9);  // of 1/256 texel
  for (uint32_t i = 0; i < 3 * (1 + rng.below(8)); ++i) {
    const auto axis = [&] { return std::floor(rng.range(-0.25, 1.25) * side * 256 / step) * step / 256 / side; };
    const double x = axis(), y = axis();
    m.indices.push_back(add_vertex(m, kFlat.at(x, y, 0.5), vec2(0)));
  }
  return m;
}

LightView random_light(Random& r) {
  LightView v;
  v.is_sun = r.branch({{"spot", 2}, {"sun", 1}}) == 1;
  v.half_width = log_range(r.rng, 0.2, 3);
  v.first = v.is_sun ? r.rng.range(-20, 5) : log_range(r.rng, 0.02, 0.5);
  v.last = v.first + log_range(r.rng, 5, 100);
  return v;
}

Mesh random_mesh(Random& r, const LightView& light, uint32_t side) {
  const double distance = light.is_sun ? r.rng.range(0.9 * light.first + 0.1 * light.last, light.last)
                                       : log_range(r.rng, 2 * light.first, 40);
  const Shapes s = {light, r.rng, double(side), distance};
  switch (r.branch({{"micro", 1}, {"small", 2}, {"large", 2}, {"grid", 2}, {"covering", 1}, {"crossing", 1}})) {
    case 0:
      return s.soup(20 + r.rng.below(60), 0.15, 0.6);
    case 1:
      return s.soup(10 + r.rng.below(40), 0.6, 6);
    case 2:
      return s.soup(1 + r.rng.below(6), 6, 4.0 * side);
    case 3:
      return s.grid();
    case 4:
      return cover(light, distance);
    default:
      return s.crossing(1 + r.rng.below(3));
  }
}

// The mesh turned and moved, and the place that puts it back.
glm::dmat4 turn(Pcg32& rng, Mesh& mesh) {
  glm::dmat4 place = glm::translate(glm::dmat4(1), glm::dvec3(rng.range(-3, 3), rng.range(-3, 3), rng.range(-3, 3)));
  place = glm::rotate(place, rng.range(-3, 3), glm::normalize(glm::dvec3(rng.range(-1, 1), 1, rng.range(-1, 1))));
  const glm::dmat4 back = glm::inverse(place);
  for (vec3& p : mesh.positions) p = vec3(back * glm::dvec4(glm::dvec3(p), 1));
  return place;
}

Look random_look(Random& r, uint32_t textures) {
  if (r.branch({{"opaque", 2}, {"masked", 1}}) == 0) return {};
  return masked_look(static_cast<float>(r.rng.range(0.3, 1)), static_cast<float>(r.rng.range(0.1, 0.9)),
                     texture_name(r.rng.below(textures), r.rng.below(3)));
}

void add_caster(Random& r, Builder& b, uint32_t tile, uint32_t side, bool moving, uint32_t textures) {
  Look look = random_look(r, textures);
  look.moving = moving;
  if (r.branch({{"in_space", 7}, {"on_the_grid", 1}}) == 1) return b.add(on_grid(r.rng, side), look, {{tile, kFlat}});
  const LightView light = random_light(r);
  Mesh mesh = random_mesh(r, light, side);
  Placed placed = {tile, light};
  if (r.branch({{"straight", 1}, {"turned", 1}}) == 1) placed.place = turn(r.rng, mesh);
  std::vector<Placed> all = {placed};
  if (r.branch({{"one_caster", 3}, {"instanced", 1}}) == 1) {
    Placed second = placed;
    second.place = glm::translate(second.place, glm::dvec3(r.rng.range(-1, 1), r.rng.range(-1, 1), 0));
    all.push_back(second);
  }
  b.add(mesh, look, all);
}

void add_tile(Random& r, Builder& b, const ShadowTile& t, uint32_t textures) {
  const size_t role = r.branch({{"drawn_anew", 3}, {"moved_over", 2}, {"still_alone", 1}, {"untouched", 1}});
  const uint32_t casters = 1 + r.rng.below(3);
  if (role == 0 || role == 2) {
    const uint32_t tile = b.add_still_tile(t);
    for (uint32_t i = 0; i < casters; ++i) add_caster(r, b, tile, t.side, false, textures);
  }
  if (role == 0 || role == 1) {
    const uint32_t tile = b.add_tile(t);
    for (uint32_t i = r.rng.below(2); i < casters; ++i) add_caster(r, b, tile, t.side, true, textures);
  }
}

void split(Random& r, Builder& b, const ShadowTile& t, uint32_t textures, double chance) {
  if (t.side > 512 || (t.side > 8 && r.rng.unit() < chance)) {
    for (uint32_t i = 0; i < 4; ++i)
      split(r, b, {t.x + (i & 1) * t.side / 2, t.y + i / 2 * t.side / 2, t.side / 2}, textures, 0.75 * chance);
    return;
  }
  add_tile(r, b, t, textures);
}

Case random_case(Random& r) {
  // Two fifths are over 128 texels a side, one in fifteen has over 100,000.
  uint32_t width, height;
  const uint32_t size = r.rng.below(10);
  if (r.branch({{"powers_of_two", 2}, {"any_size", 1}}) == 0) {
    width = 8u << r.rng.below(6), height = 8u << r.rng.below(6);
    if (size < 4) width = height = size == 0 ? 512 : 256;
  } else {
    const uint32_t least = size < 4 ? 129 : 8;
    width = least + r.rng.below(250), height = least + r.rng.below(250);
  }
  Builder b(width, height);
  const uint32_t textures = 1 + r.rng.below(3);
  for (uint32_t i = 0; i < textures; ++i)
    b.add_texture(alpha_texture(1 + r.rng.below(16), 1 + r.rng.below(16), 1 + r.rng.below(3), Format::rgba8_srgb,
                                [&](uint32_t, uint32_t, uint32_t) { return r.rng.below(256); }));
  // One square of tiles after the other, as many as fit.
  const uint32_t side = std::bit_floor(std::min(width, height));
  for (uint32_t y = 0; y + side <= height; y += side)
    for (uint32_t x = 0; x + side <= width && x < 4 * side; x += side) split(r, b, {x, y, side}, textures, 0.7);
  return b.finish();
}

std::vector<std::string> branches() {
  return {"spot",        "sun",       "micro",         "small",     "large",      "grid",
          "covering",    "crossing",  "opaque",        "masked",    "in_space",   "on_the_grid",
          "straight",    "turned",    "one_caster",    "instanced", "drawn_anew", "moved_over",
          "still_alone", "untouched", "powers_of_two", "any_size"};
}

}  // namespace

Inputs inputs() {
  std::vector<HardCase> hard = hard_cases();
  std::ranges::move(hostile_cases(), std::back_inserter(hard));
  return {.random = random_case, .branches = branches(), .hard = std::move(hard), .smaller = smaller_draws};
}

Case frame(const FrameInputs& f) {
  Case c;
  c.name = "frame";
  c.extent = {std::max(f.shadows.width, 1u), std::max(f.shadows.height, 1u)};
  c.set_params(ShadowAtlasParams{f.scene, f.shadows});
  const auto held = [&](const Bytes& earlier) { return earlier.empty() ? Bytes(pixels(c) * sizeof(float)) : earlier; };
  c.inputs["still"] = held(f.history.shadow_still);
  c.inputs["depth"] = held(f.history.shadow_depth);
  return c;
}

}  // namespace assay::shadow_atlas
