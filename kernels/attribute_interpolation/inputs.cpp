#include "kernels/attribute_interpolation/inputs.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/crop.h"
#include "kernels/attribute_interpolation/classes.h"

namespace assay::attribute_interpolation {

namespace {

constexpr double kPi = 3.14159265358979323846;

vec3 unit_vector(Pcg32& rng) {
  const double z = rng.range(-1, 1), angle = rng.range(0, 2 * kPi), r = std::sqrt(1 - z * z);
  return vec3(r * std::cos(angle), r * std::sin(angle), z);
}
vec3 axis(Pcg32& rng) {
  vec3 a(0);
  a[static_cast<int>(rng.below(3))] = rng.below(2) == 0 ? 1.0f : -1.0f;
  return a;
}

// Three vertices' attributes: a curved patch, or a wall that lies along an axis.
std::array<VertexAttributes, 3> random_attributes(Random& r, bool wall) {
  const vec3 n = wall ? axis(r.rng) : unit_vector(r.rng);
  vec3 t = wall ? axis(r.rng) : unit_vector(r.rng);
  while (std::fabs(dot(t, n)) > 0.9f) t = wall ? axis(r.rng) : unit_vector(r.rng);
  const float hand = r.rng.below(2) == 0 ? 1.0f : -1.0f;
  std::array<VertexAttributes, 3> a;
  for (VertexAttributes& v : a) {
    const vec3 bent = wall ? n : normalize(n + 0.3f * unit_vector(r.rng));
    v = {bent, vec4(normalize(t - dot(t, bent) * bent), hand), vec2(0)};
  }
  return a;
}

const InputClass& random_class(Random& r) {
  static const auto kChoices = [](const char* name) { return &input_class(name); };
  const InputClass* classes[] = {kChoices("typical"),
                                 kChoices("huge"),
                                 kChoices("single_sample"),
                                 kChoices("micro"),
                                 kChoices("sliver_1e-2"),
                                 kChoices("sliver_1e-4"),
                                 kChoices("sliver_1e-4_centre"),
                                 kChoices("sliver_1e-6_centre"),
                                 kChoices("crossing"),
                                 kChoices("tiny_w"),
                                 kChoices("grazing"),
                                 kChoices("grazing_1e-5"),
                                 kChoices("fov_170"),
                                 kChoices("16k"),
                                 kChoices("16k_huge"),
                                 kChoices("16k_single_sample")};
  return *classes[r.branch({{"typical", 4},
                            {"huge", 1},
                            {"single_sample", 2},
                            {"micro", 1},
                            {"sliver_1e-2", 0.7},
                            {"sliver_1e-4", 0.5},
                            {"sliver_1e-4_centre", 0.5},
                            {"sliver_1e-6_centre", 0.5},
                            {"crossing", 1},
                            {"tiny_w", 1},
                            {"grazing", 1},
                            {"grazing_1e-5", 0.7},
                            {"fov_170", 1},
                            {"16k", 1},
                            {"16k_huge", 0.7},
                            {"16k_single_sample", 0.7}})];
}

// Of classes that cannot be decided a case holds a few, among typical triangles: what is not judged stays rare.
constexpr size_t kMostUndecided = 64;
const InputClass& class_of(const InputClass& k, size_t i) {
  return k.undecided && i >= kMostUndecided ? input_class("typical") : k;
}

Case random_clip_case(Random& r, Extent e) {
  const InputClass& k = random_class(r);
  std::vector<ClipSample> samples(pixel_count(e));
  for (size_t i = 0; i < samples.size(); ++i) samples[i] = any_sample(class_of(k, i), r.rng);
  const bool short_row = r.branch({{"whole_rows", 4}, {"short_row", 1}}) == 1;
  if (short_row) samples.resize(samples.size() - r.rng.below(std::min<uint32_t>(e.width, 1000)));
  return clip_case(k.name, samples, e.width);
}

glm::dmat4 random_place(Random& r) {
  const size_t how = r.branch({{"placed", 3}, {"mirrored", 2}, {"stretched", 1}});
  glm::dmat4 place = glm::translate(glm::dmat4(1), glm::dvec3(unit_vector(r.rng)) * r.rng.range(0, 3));
  place = glm::rotate(place, r.rng.range(-3, 3), glm::dvec3(unit_vector(r.rng)));
  if (how == 1) place = glm::scale(place, glm::dvec3(-1, 1, 1));
  if (how == 2) place = glm::scale(place, glm::dvec3(r.rng.range(0.2, 5), r.rng.range(0.2, 5), r.rng.range(0.2, 5)));
  return place;
}

// Blocks of pixels show a triangle each, in space so that it is one of its class for the block's middle.
Case random_scene_case(Random& r, Extent e) {
  SceneBuilder scene(e);
  const bool holes = r.branch({{"covered", 2}, {"holes", 1}}) == 1;
  const bool walls = r.branch({{"curved", 3}, {"walls", 1}}) == 1;
  const uint32_t most_blocks = 4096;
  uint32_t side = 1 + r.rng.below(8);
  while (tile_count(e, side) > most_blocks) side *= 2;
  const Extent blocks = tiles_of(e, side);
  const InputClass& k = random_class(r);
  uint32_t left = 0;  // blocks until the next surface
  size_t triangles = 0;
  for (uint32_t by = 0; by < blocks.height; ++by)
    for (uint32_t bx = 0; bx < blocks.width; ++bx, --left) {
      if (left == 0) {
        scene.add_surface(random_place(r));
        left = 1 + r.rng.below(ceil_div(blocks.width * blocks.height, 4));
      }
      if (holes && r.rng.below(4) == 0) continue;
      const uvec2 middle = {std::min(bx * side + side / 2, e.width - 1), std::min(by * side + side / 2, e.height - 1)};
      const ClipSample s = class_of(k, triangles++ * side * side).make(r.rng, middle, {e.width, e.height});
      std::array<vec3, 3> p;
      const vec3 corners[] = {s.v0, s.v1, s.v2};
      for (size_t i = 0; i < 3; ++i) p[i] = scene.object_position(glm::dvec3(corners[i]));
      const uint32_t triangle = scene.add_triangle(p, random_attributes(r, walls));
      for (uint32_t y = by * side; y < std::min((by + 1) * side, e.height); ++y)
        for (uint32_t x = bx * side; x < std::min((bx + 1) * side, e.width); ++x) scene.show(x, y, triangle);
    }
  return scene.finish(k.name);
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, 32);
  if (r.branch({{"clip_entry", 1}, {"scene_entry", 1}}) == 0) return random_clip_case(r, e);
  return random_scene_case(r, e);
}

// Crops of the visibility buffer; the camera stays, so their pixels see the same triangles from elsewhere: still a
// case.
std::vector<Case> smaller(const Case& c) {
  std::vector<Case> out;
  const auto samples = c.input<ClipSample>("clip_samples");
  const auto visibility = c.input<uvec2>("visibility");
  for (const Crop& crop : smaller_crops(c.extent)) {
    Case s = c;
    s.extent = crop.size;
    AttributeParams p = c.params<AttributeParams>();
    p.width = crop.size.width, p.height = crop.size.height;
    if (samples.size() == pixels(c)) {
      const auto kept = cropped(samples, c.extent, crop);
      p.clip_samples = static_cast<uint>(kept.size());
      s.set_input("clip_samples", kept);
    } else if (!samples.empty()) {
      continue;
    }
    s.set_params(p);
    s.set_input("visibility", cropped(visibility, c.extent, crop));
    out.push_back(std::move(s));
  }
  return out;
}

std::vector<std::string> branches() {
  std::vector<std::string> names = {"clip_entry", "scene_entry", "whole_rows", "short_row", "covered",  "holes",
                                    "curved",     "walls",       "placed",     "mirrored",  "stretched"};
  for (const InputClass& k : input_classes()) names.push_back(k.name);
  names.insert(names.end(), kExtentBranches.begin(), kExtentBranches.end());
  return names;
}

}  // namespace

Inputs inputs() { return {.random = random_case, .branches = branches(), .hard = hard_cases(), .smaller = smaller}; }

// A hilly surface that covers the screen: a lattice of vertices eight pixels apart, two triangles a cell.
Case typical(Extent e) {
  constexpr uint32_t kCell = 8;
  SceneBuilder scene(e);
  scene.add_surface(glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(1, -2, 3)), 0.7, glm::dvec3(0.6, 0, 0.8)));
  const Extent cells = tiles_of(e, kCell);
  const auto corner = [&](uint32_t i, uint32_t j) { return j * (cells.width + 1) + i; };
  for (uint32_t j = 0; j <= cells.height; ++j)
    for (uint32_t i = 0; i <= cells.width; ++i) {
      const double x = i * kCell, y = j * kCell, w = 8 + 2 * std::sin(0.011 * x) + 3 * std::cos(0.007 * y);
      scene.positions.push_back(scene.object_position({(2 * x / e.width - 1) * w, (2 * y / e.height - 1) * w, w}));
      const vec3 n = normalize(vec3(0.4 * std::cos(0.011 * x), -0.5 * std::sin(0.007 * y), 1));
      scene.attributes.push_back({n, vec4(normalize(vec3(1, 0, -n.x / n.z)), 1), vec2(x, y)});
    }
  for (uint32_t j = 0; j < cells.height; ++j)
    for (uint32_t i = 0; i < cells.width; ++i)
      scene.indices.insert(scene.indices.end(), {corner(i, j), corner(i, j + 1), corner(i + 1, j), corner(i + 1, j),
                                                 corner(i, j + 1), corner(i + 1, j + 1)});
  scene.surfaces.back().triangle_count = static_cast<uint32_t>(scene.indices.size() / 3);
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      const bool second = x % kCell + y % kCell + 1 >= kCell;
      scene.show(x, y, 2 * (y / kCell * cells.width + x / kCell) + second);
    }
  return scene.finish("typical");
}

Case frame(const FrameInputs& f) {
  Case c = {.name = "frame", .extent = f.extent};
  c.set_params(AttributeParams{.width = f.extent.width,
                               .height = f.extent.height,
                               .vertices = f.scene.vertices,
                               .indices = f.scene.indices,
                               .surfaces = f.scene.surfaces,
                               .clip_samples = 0,
                               .probe_factor = kProbeFactor,
                               .probe_addend = kProbeAddend});
  c.set_input("clip_samples", std::vector<ClipSample>());
  return c;
}

}  // namespace assay::attribute_interpolation
