// Cases for the visibility draw, put together mesh by mesh.
#pragma once
#include <glm/mat4x4.hpp>
#include <vector>

#include "harness/oracle.h"
#include "kernels/visibility/layout.h"

namespace assay::visibility {

constexpr float kNear = 0.125f;  // metres

struct Mesh {
  std::vector<vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
};
uint32_t add_vertex(Mesh&, const vec3& position, const vec2& uv, const vec3& normal = vec3(0, 0, 1));
void add_triangle(Mesh&, uint32_t a, uint32_t b, uint32_t c);
// n x n cells over a function of [0,1]^2; triangles counter-clockwise where u runs right and v runs up.
template <class F>
void add_grid(Mesh& m, uint32_t columns, uint32_t rows, F position) {
  const auto first = static_cast<uint32_t>(m.positions.size());
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= columns; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(columns),
                  v = static_cast<float>(j) / static_cast<float>(rows);
      add_vertex(m, position(u, v), vec2(u, v));
    }
  for (uint32_t j = 0; j < rows; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = first + j * (columns + 1) + i, b = a + columns + 1;
      add_triangle(m, a, a + 1, b);
      add_triangle(m, a + 1, b + 1, b);
    }
}

// A camera at the origin that looks along -z, y up; 90 degrees across the smaller side.
struct View {
  Extent extent;
  glm::dmat4 clip() const;  // rows x, y, (0), w as a matrix that multiplies from the left
  // The point that is seen at framebuffer coordinates x, y, at this distance along -z.
  vec3 at(double x, double y, double distance) const;
};

struct Look {
  MaterialRecord material = {vec4(1), kNoTexture, 0.5f, 0, 0};
  bool instanced = false;
};

class SceneBuilder {
 public:
  explicit SceneBuilder(Extent);
  // One draw of the mesh at each of these places; a mirroring place flips the winding, and all of a draw's do or none.
  void add(const Mesh&, const Look&, const std::vector<glm::dmat4>& places = {glm::dmat4(1)});
  // Clip rows as they are, without a camera.
  void add_rows(const Mesh&, const Look&, const glm::dmat4& clip);
  uint32_t add_texture(Texture);  // its array's index
  Case finish(std::string name = {}) const;
  View view;

 private:
  void add_draw(const Mesh&, const Look&, std::vector<SurfaceRecord>);
  struct Draw {
    DrawCommand command;
    uint32_t bucket;
  };
  std::vector<vec3> positions_;
  std::vector<VertexAttributes> attributes_;
  std::vector<uint32_t> indices_;
  std::vector<SurfaceRecord> surfaces_;
  std::vector<MaterialRecord> materials_;
  std::vector<Draw> draws_;
  std::vector<Texture> textures_;
};

// RGBA8 whose alpha is a function of the texel; `alpha`: x, y, layer to 0..255.
Texture alpha_texture(uint32_t width, uint32_t height, uint32_t layers, Format,
                      const std::function<uint32_t(uint32_t, uint32_t, uint32_t)>& alpha);
uint32_t texture_name(uint32_t array, uint32_t layer);

}  // namespace assay::visibility
