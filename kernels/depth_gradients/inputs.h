#pragma once
#include <array>
#include <glm/glm.hpp>

#include "harness/oracle.h"
#include "kernels/depth_gradients/layout.h"

namespace assay::depth_gradients {

using glm::dvec2;
using glm::dvec3;

Inputs inputs();
std::vector<HardCase> hard_cases();
std::vector<Mutant> mutants();
Case typical(Extent);  // hills that cover the screen, triangles of eight pixels
Case in_frame(const FrameInputs&);
// The stored gradient against the exact one, by kinds of surface.
ErrorTable error_table();

// ---- For hard.cpp and errors.cpp

// A plane as the screen has it: 1/w = (1 + slope . (pixel - at)) / w.
struct Plane {
  dvec2 at = {};     // pixels
  double w = 1;      // view depth there, metres
  dvec2 slope = {};  // its gradient
  double inverse_depth(const dvec2& pixel) const { return (1 + dot(slope, pixel - at)) / w; }
};

// Triangles in clip space, and which of them each pixel shows.
struct Picture {
  explicit Picture(Extent);
  Extent extent;
  std::vector<uvec2> visibility;
  std::vector<float> depth;
  std::vector<vec3> positions = {};
  std::vector<uint32_t> indices = {};
  std::vector<SurfaceRecord> surfaces = {};

  // Clip rows as they are; of no object space of its own, one whose positions are clip x, y and w.
  void add_surface(SurfaceRecord);
  void add_surface();
  // Of the latest surface; corners (x, y, w) in clip space.
  uint32_t add_triangle(const std::array<dvec3, 3>& corners);
  // With corners at these pixels of the plane, behind the eye where it is. One in the plane of the eye moves a little.
  uint32_t add_triangle(const Plane&, const std::array<dvec2, 3>& pixels);
  // Of the latest surface, by the plane's depth.
  void show(uint32_t x, uint32_t y, uint32_t triangle, const Plane&);
  void show_all(uint32_t triangle, const Plane&);
  Case to_case() const;
};

}  // namespace assay::depth_gradients
