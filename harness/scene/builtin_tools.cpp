#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/builtin.h"

namespace assay::scene::builtin {

uint32_t add_image(Scene& s, const std::string& name, uint32_t side, const Paint& paint) {
  Image image = {name, side, side, {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const float scale = 1.0f / static_cast<float>(side);
      const glm::vec4 c = paint((static_cast<float>(x) + 0.5f) * scale, (static_cast<float>(y) + 0.5f) * scale);
      for (int i = 0; i < 4; ++i)
        image.rgba.push_back(static_cast<uint8_t>(std::lround(glm::clamp(c[i], 0.0f, 1.0f) * 255)));
    }
  s.images.push_back(std::move(image));
  return static_cast<uint32_t>(s.images.size() - 1);
}

uint32_t add_material(Scene& s, Material m) {
  s.materials.push_back(std::move(m));
  return static_cast<uint32_t>(s.materials.size() - 1);
}

void append_patch(Mesh& mesh, uint32_t columns, uint32_t rows, const glm::vec2& repeats, const Patch& point) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (uint32_t r = 0; r <= rows; ++r)
    for (uint32_t c = 0; c <= columns; ++c) {
      const double u = static_cast<double>(c) / columns, v = static_cast<double>(r) / rows, step = 1e-4;
      const glm::dvec3 du = point(u + step, v) - point(u - step, v), dv = point(u, v + step) - point(u, v - step);
      const glm::vec3 normal(normalize(cross(du, dv)));
      mesh.positions.emplace_back(point(u, v));
      // glTF's v runs down.
      mesh.attributes.push_back({normal, glm::vec4(glm::vec3(normalize(du)), 1),
                                 glm::vec2(static_cast<float>(u), static_cast<float>(1 - v)) * repeats});
    }
  for (uint32_t r = 0; r < rows; ++r)
    for (uint32_t c = 0; c < columns; ++c) {
      const uint32_t a = base + r * (columns + 1) + c, b = a + 1, d = a + columns + 1, e = d + 1;
      for (const uint32_t i : {a, b, e, a, e, d}) mesh.indices.push_back(i);
    }
}

void end_part(Mesh& mesh, uint32_t material) {
  uint32_t first = 0;
  for (const Part& part : mesh.parts) first += part.index_count;
  mesh.parts.push_back({first, static_cast<uint32_t>(mesh.indices.size()) - first, material});
}

uint32_t add_mesh(Scene& s, Mesh mesh, uint32_t material) {
  end_part(mesh, material);
  s.meshes.push_back(std::move(mesh));
  return static_cast<uint32_t>(s.meshes.size() - 1);
}

uint32_t add_patch_mesh(Scene& s, const std::string& name, uint32_t material, uint32_t columns, uint32_t rows,
                        const glm::vec2& repeats, const Patch& point) {
  Mesh mesh;
  mesh.name = name;
  append_patch(mesh, columns, rows, repeats, point);
  return add_mesh(s, std::move(mesh), material);
}

void place(Scene& s, uint32_t mesh, const glm::dvec3& at, double turn_rad, const glm::dvec3& scale) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), at);
  s.instances.push_back({mesh, glm::scale(glm::rotate(moved, turn_rad, glm::dvec3(0, 1, 0)), scale)});
}

void set_motion(Scene& s, const std::string& mesh, const Motion& motion) {
  for (Instance& i : s.instances)
    if (s.meshes[i.mesh].name == mesh) i.motion = motion;
}

glm::dvec3 sphere(double u, double v) {
  const double polar = (0.002 + 0.996 * v) * glm::pi<double>();
  return {std::sin(polar) * std::sin(u * kTau), -std::cos(polar), std::sin(polar) * std::cos(u * kTau)};
}

glm::vec4 leaves(float u, float v) {
  float inside = 0.06f - std::fabs(u - 0.5f) - 0.05f * v;
  for (int i = 0; i < 7; ++i) {
    const float side = i % 2 ? 1.0f : -1.0f, root = 0.88f - 0.12f * static_cast<float>(i);
    const float along = ((u - 0.5f) * side * 0.8f + (root - v) * 0.6f) / 0.46f;  // 0 at the stem, 1 at the tip
    const float across = (u - 0.5f) * side * 0.6f - (root - v) * 0.8f;
    if (along > 0 && along < 1) inside = std::fmax(inside, 0.22f * along * (1 - along) - std::fabs(across));
  }
  return {0.2f + 0.2f * v, 0.5f - 0.15f * v, 0.12f, 0.5f + inside * 16};
}
glm::vec4 grille(float u, float v) {
  const float x = std::fabs(std::fmod(u * 8, 1.0f) - 0.5f), y = std::fabs(std::fmod(v * 8, 1.0f) - 0.5f);
  return {0.3f, 0.3f, 0.32f, 0.5f + (std::fmax(x, y) - 0.36f) * 6};
}

}  // namespace assay::scene::builtin
