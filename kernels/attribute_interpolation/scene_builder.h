// Cases for attribute interpolation: clip samples, or a scene with the visibility buffer that shows it.
#pragma once
#include <glm/mat4x4.hpp>

#include "harness/oracle.h"
#include "kernels/attribute_interpolation/layout.h"

namespace assay::attribute_interpolation {

// Pixel i of a case that is `width` pixels wide shows sample i; missing ones of the last row show nothing.
Case clip_case(std::string name, const std::vector<ClipSample>&, uint32_t width);

// A scene, triangle by triangle, and which of them each pixel shows.
class SceneBuilder {
 public:
  explicit SceneBuilder(Extent);
  // A camera at the origin that looks along -z, 90 degrees across the smaller side, and a placing transform.
  uint32_t add_surface(const glm::dmat4& place);
  uint32_t add_surface(const SurfaceRecord&);  // rows as they are
  // Of the latest surface. Object-space positions.
  uint32_t add_triangle(const std::array<vec3, 3>&, const std::array<VertexAttributes, 3>&);
  // Where an object-space vertex of the latest surface has to be to have these clip coordinates.
  vec3 object_position(const glm::dvec3& clip) const;
  void show(uint32_t x, uint32_t y, uint32_t triangle);  // of the latest surface
  void show_bits(uint32_t x, uint32_t y, uvec2 bits);
  Case finish(std::string name = {}) const;
  Extent extent;

  std::vector<vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
  std::vector<SurfaceRecord> surfaces;

 private:
  std::vector<uvec2> visibility_;
};

VertexAttributes flat_attributes();  // normal +z, tangent +x

}  // namespace assay::attribute_interpolation
