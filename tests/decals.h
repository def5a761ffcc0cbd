// What decals make of a pixel's material, from the scene's own decals by brute force, in double: every one is asked, in
// its own box, and its pictures are read as they are.
#pragma once
#include "harness/scene/scene.h"
#include "tests/surface.h"

namespace assay::tests {

struct Decaled {
  std::array<Range, 3> base;  // linear
  Range roughness;
  glm::dvec3 normal;
  double normal_rad = 0;  // by which it may be off
  bool touched[3] = {};   // base colour, normal, roughness: where not, the texel's bits stay
  bool at_face = false;   // within rounding of a box's face: it may have the decal or not
};
// `before` is what texturing left; `position`, where a renderer in floats found it from its own depth, and its change a
// pixel are relative to the camera, world axes.
Decaled decaled(const scene::Scene&, const scene::Camera&, const GBufferPixel& before, const glm::dvec3& position,
                const glm::dvec3& per_x, const glm::dvec3& per_y);
// Which channels of `after` are not that, with both; empty if none.
std::string disagreement(const Decaled&, const GBufferPixel& before, const GBufferPixel& after);

// Where a world position is in a decal's box, -1..1 on each axis of the box's own, and the change of that by world
// position: the three rows of a matrix.
struct InBox {
  glm::dvec3 at;
  glm::dmat3 by_position;
};
InBox in_box(const scene::Scene&, const scene::Decal&, const glm::dvec3& world);

}  // namespace assay::tests
