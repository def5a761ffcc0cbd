// Meshes and textures for the cases of kernels that draw. Host only.
#pragma once
#include <functional>
#include <vector>

#include "harness/formats/scene.h"
#include "harness/texture.h"

namespace assay::raster {

struct Mesh {
  std::vector<vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
};
uint32_t add_vertex(Mesh&, const vec3& position, const vec2& uv, const vec3& normal = vec3(0, 0, 1));
void add_triangle(Mesh&, uint32_t a, uint32_t b, uint32_t c);
// Cells over a function of [0,1]^2; triangles counter-clockwise where u runs right and v runs up.
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

// RGBA8 whose alpha is a function of the texel; `alpha`: x, y, layer to 0..255.
Texture alpha_texture(uint32_t width, uint32_t height, uint32_t layers, Format,
                      const std::function<uint32_t(uint32_t, uint32_t, uint32_t)>& alpha);
uint32_t texture_name(uint32_t array, uint32_t layer);

}  // namespace assay::raster
