#include "kernels/visibility/inputs.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/raster/smaller.h"

namespace assay::visibility {

namespace {

constexpr double kPi = 3.14159265358979323846;

double log_range(Pcg32& rng, double low, double high) { return low * std::pow(high / low, rng.unit()); }

vec3 unit_vector(Pcg32& rng) {
  const double z = rng.range(-1, 1), angle = rng.range(0, 2 * kPi), r = std::sqrt(1 - z * z);
  return vec3(r * std::cos(angle), r * std::sin(angle), z);
}

// Pixel coordinates, mostly on the screen, a tenth of the time up to a screen beside it.
double somewhere(Pcg32& rng, uint32_t size) {
  return rng.unit() < 0.9 ? rng.range(0, size) : rng.range(-1.0 * size, 2.0 * size);
}

struct Shapes {
  const View& view;
  Pcg32& rng;
  double distance;  // of the whole thing, metres

  vec3 at(double x, double y) const { return view.at(x, y, distance * rng.range(0.9, 1.1)); }
  vec2 uv() const { return vec2(rng.range(-1, 2), rng.range(-1, 2)); }

  // Separate triangles of about this many pixels.
  Mesh soup(uint32_t count, double low, double high) const {
    Mesh m;
    for (uint32_t i = 0; i < count; ++i) {
      const double x = somewhere(rng, view.extent.width), y = somewhere(rng, view.extent.height),
                   size = log_range(rng, low, high);
      uint32_t v[3];
      for (uint32_t& vertex : v)
        vertex = add_vertex(m, at(x + rng.range(-size, size), y + rng.range(-size, size)), uv(), unit_vector(rng));
      add_triangle(m, v[0], v[1], v[2]);
    }
    return m;
  }
  Mesh grid() const {
    Mesh m;
    const double x = somewhere(rng, view.extent.width), y = somewhere(rng, view.extent.height);
    const double cell = log_range(rng, 0.7, 40), slant = rng.range(-0.5, 0.5);
    const uint32_t columns = 1 + rng.below(12), rows = 1 + rng.below(12);
    add_grid(m, columns, rows, [&](float s, float t) {
      return view.at(x + cell * columns * (s + slant * t), y - cell * rows * (t - slant * s),
                     distance * (1 + 0.3 * s - 0.2 * t));
    });
    return m;
  }
  // Triangles around a centre; the last closes the ring.
  Mesh fan() const {
    Mesh m;
    const double x = somewhere(rng, view.extent.width), y = somewhere(rng, view.extent.height),
                 radius = log_range(rng, 2, 100);
    const uint32_t spokes = 3 + rng.below(13);
    const uint32_t centre = add_vertex(m, at(x, y), vec2(0.5f));
    for (uint32_t i = 0; i < spokes; ++i) {
      const double angle = 2 * kPi * i / spokes;
      add_vertex(m, at(x + radius * std::cos(angle), y - radius * std::sin(angle)), uv());
    }
    for (uint32_t i = 0; i < spokes; ++i) add_triangle(m, centre, centre + 1 + i, centre + 1 + (i + 1) % spokes);
    return m;
  }
  // Some vertices before the eye, some behind it.
  Mesh crossing(uint32_t count) const {
    Mesh m;
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t v[3];
      for (uint32_t& vertex : v) {
        const double depth = rng.unit() < 0.5 ? log_range(rng, 0.2, 20) : -log_range(rng, 0.01, 20);
        vertex = add_vertex(m, vec3(rng.range(-3, 3), rng.range(-3, 3), -depth), uv());
      }
      add_triangle(m, v[0], v[1], v[2]);
    }
    return m;
  }
  Mesh behind(uint32_t count) const {
    Mesh m = soup(count, 3, 40);
    for (vec3& p : m.positions) p = vec3(p.x, p.y, -p.z);
    return m;
  }
  // Overlapping pieces of one plane that faces nobody in particular: z-fighting.
  Mesh coplanar(uint32_t count) const {
    Mesh m;
    const double tilt_x = rng.range(-0.3, 0.3), tilt_y = rng.range(-0.3, 0.3);
    for (uint32_t i = 0; i < count; ++i) {
      uint32_t v[3];
      for (uint32_t& vertex : v) {
        const double x = rng.range(-1, 1), y = rng.range(-1, 1);
        vertex = add_vertex(m, vec3(distance * x, distance * y, -distance * (1 + tilt_x * x + tilt_y * y)), uv());
      }
      add_triangle(m, v[0], v[1], v[2]);
    }
    return m;
  }
};

// Vertices on the sub-pixel grid and w = 1: coverage and depth are exact, every tie is decided by order.
Mesh on_grid(const Extent& e, Pcg32& rng) {
  Mesh m;
  const double step = 1 << rng.below(9);  // of 1/256 pixel
  const uint32_t count = 1 + rng.below(6);
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t v[4];
    for (uint32_t& vertex : v) {
      const double x = std::floor(rng.range(0, e.width) * 256 / step) * step / 256;
      const double y = std::floor(rng.range(0, e.height) * 256 / step) * step / 256;
      vertex = add_vertex(m, vec3(2 * x / e.width - 1, 2 * y / e.height - 1, 0), vec2(0));
    }
    add_triangle(m, v[0], v[1], v[2]);
    add_triangle(m, v[1], v[0], v[3]);
  }
  return m;
}

uint32_t add_random_texture(SceneBuilder& scene, Pcg32& rng) {
  const uint32_t width = 1 + rng.below(16), height = 1 + rng.below(16), layers = 1 + rng.below(3);
  const bool hard_edged = rng.below(2) == 0;
  return scene.add_texture(alpha_texture(width, height, layers, Format::rgba8_srgb, [&](uint32_t, uint32_t, uint32_t) {
    return hard_edged ? 255 * rng.below(2) : rng.below(256);
  }));
}

Look random_look(Random& r, uint32_t arrays) {
  Look look;
  MaterialRecord& m = look.material;
  if (r.branch({{"single_sided", 2}, {"double_sided", 1}}) == 1) m.flags |= kMaterialDoubleSided;
  if (r.branch({{"opaque", 2}, {"masked", 1}}) == 0) return look;
  m.flags |= kMaterialMasked;
  m.alpha_cutoff = static_cast<float>(r.rng.range(0.1, 0.9));
  m.base_colour = vec4(1, 1, 1, r.rng.range(0.3, 1));
  if (r.branch({{"textured_cut", 4}, {"untextured_cut", 1}}) == 0)
    m.base_texture = texture_name(r.rng.below(arrays), r.rng.below(3));
  return look;
}

// The mesh turned about its middle, so that the placed one has it back where it was.
std::vector<glm::dmat4> places_for(Random& r, Mesh& mesh, Look& look) {
  glm::dvec3 middle(0);
  for (const vec3& p : mesh.positions) middle += glm::dvec3(p) / static_cast<double>(mesh.positions.size());
  for (vec3& p : mesh.positions) p = vec3(glm::dvec3(p) - middle);
  const size_t how = r.branch({{"placed_once", 3}, {"instanced", 2}, {"mirrored", 2}, {"mirrored_instances", 1}});
  look.instanced = how == 1 || how == 3;
  const uint32_t count = look.instanced ? 2 + r.rng.below(6) : 1;
  const double size = 0.4 * std::fabs(middle.z);
  std::vector<glm::dmat4> places;
  for (uint32_t i = 0; i < count; ++i) {
    glm::dmat4 place = glm::translate(glm::dmat4(1), middle);
    if (i > 0) {
      place = glm::translate(place,
                             glm::dvec3(r.rng.range(-size, size), r.rng.range(-size, size), r.rng.range(-size, size)));
      place = glm::rotate(place, r.rng.range(-3, 3), glm::dvec3(unit_vector(r.rng)));
    }
    if (how >= 2) place = glm::scale(place, glm::dvec3(-1, 1, 1));
    places.push_back(place);
  }
  return places;
}

Mesh random_mesh(Random& r, const View& view) {
  const Shapes s = {view, r.rng, log_range(r.rng, 0.3, 60)};
  const double side = std::max(view.extent.width, view.extent.height);
  switch (r.branch({{"micro", 2},
                    {"small", 2},
                    {"medium", 2},
                    {"huge", 1},
                    {"grid", 2},
                    {"fan", 2},
                    {"crossing", 1},
                    {"behind", 0.5},
                    {"coplanar", 0.5}})) {
    case 0:
      return s.soup(20 + r.rng.below(200), 0.15, 0.6);
    case 1:
      return s.soup(10 + r.rng.below(100), 0.6, 6);
    case 2:
      return s.soup(2 + r.rng.below(20), 6, 60);
    case 3:
      return s.soup(1 + r.rng.below(3), 0.5 * side, 20 * side);
    case 4:
      return s.grid();
    case 5:
      return s.fan();
    case 6:
      return s.crossing(1 + r.rng.below(4));
    case 7:
      return s.behind(1 + r.rng.below(10));
    default:
      return s.coplanar(2 + r.rng.below(3));
  }
}

Case random_case(Random& r) {
  SceneBuilder scene(random_extent(r, 32));
  const uint32_t arrays = 1 + r.rng.below(3);
  for (uint32_t i = 0; i < arrays; ++i) add_random_texture(scene, r.rng);
  const uint32_t batches = 1 + r.rng.below(6);
  for (uint32_t i = 0; i < batches; ++i) {
    Look look = random_look(r, arrays);
    if (r.branch({{"in_space", 9}, {"on_the_grid", 1}}) == 1) {
      scene.add_rows(on_grid(scene.view.extent, r.rng), look,
                     glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1));
      continue;
    }
    Mesh mesh = random_mesh(r, scene.view);
    const std::vector<glm::dmat4> places = places_for(r, mesh, look);
    scene.add(mesh, look, places);
  }
  return scene.finish();
}

// Halves of what is drawn, half the target.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> out = raster::smaller_draws(c);
  for (const Extent e :
       {Extent{(c.extent.width + 1) / 2, c.extent.height}, Extent{c.extent.width, (c.extent.height + 1) / 2}}) {
    Case s = c;
    s.extent = e;
    if (e.width < c.extent.width || e.height < c.extent.height) out.push_back(std::move(s));
  }
  return out;
}

std::vector<std::string> branches() {
  std::vector<std::string> names = {"single_sided", "double_sided",
                                    "opaque",       "masked",
                                    "textured_cut", "untextured_cut",
                                    "placed_once",  "instanced",
                                    "mirrored",     "mirrored_instances",
                                    "micro",        "small",
                                    "medium",       "huge",
                                    "grid",         "fan",
                                    "crossing",     "behind",
                                    "coplanar",     "in_space",
                                    "on_the_grid"};
  names.insert(names.end(), kExtentBranches.begin(), kExtentBranches.end());
  return names;
}

}  // namespace

Inputs inputs() { return {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller}; }

Case frame(const FrameInputs& f) {
  Case c;
  c.name = "frame";
  c.extent = f.extent;
  c.set_params(VisibilityParams{f.scene, f.near_plane});
  return c;
}

}  // namespace assay::visibility
