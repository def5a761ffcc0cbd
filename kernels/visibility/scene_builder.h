// Cases for the visibility draw, put together mesh by mesh.
#pragma once
#include <glm/mat4x4.hpp>
#include <vector>

#include "harness/oracle.h"
#include "harness/raster/mesh.h"
#include "kernels/visibility/layout.h"

namespace assay::visibility {

using namespace raster;

constexpr float kNear = 0.125f;  // metres

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

}  // namespace assay::visibility
