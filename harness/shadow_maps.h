// Shadow atlases made by hand, for the cases of kernels that look them up: views of lights, and depths drawn exactly at
// texel centres. Host only.
#pragma once
#include <vector>

#include "harness/formats/light.h"
#include "harness/formats/shadow.h"
#include "harness/oracle.h"

namespace assay::shadowing {

// What casts a shadow: a disc, or all of a plane.
struct Caster {
  glm::dvec3 centre, normal;
  double radius = 1e30;
};

struct Atlas {
  Extent extent;
  std::vector<float> depths;  // rows, reversed
  std::vector<ShadowView> views;

  explicit Atlas(Extent e) : extent(e), depths(pixel_count(e)) {}
  // Adds a view and returns its number; rounding of points up to `reach` metres from the camera stays within its bias.
  uint32_t add_spot(const ShadowTile&, const glm::dvec3& position, const glm::dvec3& direction, double half_rad,
                    double near, double reach);
  uint32_t add_cube(const ShadowTile& first, const glm::dvec3& position, double near, double reach);  // six in a row
  // A box about a centre, so many metres to each side and along the light; depth 1 at its near end.
  uint32_t add_cascade(const ShadowTile&, const glm::dvec3& centre, const glm::dvec3& direction, double half_width,
                       double half_depth, double reach);
  // Views of a light, in a row of tiles from `first` on, and three discs between it and a point that it may light.
  void add_light(const ShadowTile& first, LightRecord&, const glm::dvec3& seen, Pcg32&);
  // Draws it into a view's tile, over what is farther from the light.
  void draw(uint32_t view, const Caster&);
  void fill(const ShadowTile&, float depth);
};

// The point at (x, y) of a view's tile, in [-1, 1], on a plane; nothing if the view does not see it there.
std::optional<glm::dvec3> point_on(const ShadowView&, double x, double y, const Caster&);

}  // namespace assay::shadowing
