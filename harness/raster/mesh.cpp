#include "harness/raster/mesh.h"

#include <algorithm>

namespace assay::raster {

uint32_t add_vertex(Mesh& m, const vec3& position, const vec2& uv, const vec3& normal) {
  m.positions.push_back(position);
  m.attributes.push_back({normal, vec4(1, 0, 0, 1), uv});
  return static_cast<uint32_t>(m.positions.size() - 1);
}

void add_triangle(Mesh& m, uint32_t a, uint32_t b, uint32_t c) { m.indices.insert(m.indices.end(), {a, b, c}); }

Texture alpha_texture(uint32_t width, uint32_t height, uint32_t layers, Format format,
                      const std::function<uint32_t(uint32_t, uint32_t, uint32_t)>& alpha) {
  Texture t = {.format = format, .width = width, .height = height, .layers = layers, .levels = 1, .bytes = {}};
  for (uint32_t layer = 0; layer < layers; ++layer)
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x)
        for (const uint32_t value : {200u, 150u, 100u, std::min(alpha(x, y, layer), 255u)})
          t.bytes.push_back(static_cast<std::byte>(value));
  return t;
}

uint32_t texture_name(uint32_t array, uint32_t layer) { return array << 16 | layer; }

}  // namespace assay::raster
