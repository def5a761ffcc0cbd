// Interpolation of a triangle at a pixel's centre, exact and with a bound of what fp32 may make of it: for the oracles
// of kernels that include harness/glsl/interpolation. The bound is derived in
// kernels/attribute_interpolation/README.md. Host only.
#pragma once
#include <optional>
#include <span>

#include "harness/formats/interpolation.h"
#include "harness/formats/scene.h"
#include "harness/rounded.h"

namespace assay::interpolation {

using glm::uvec2;
using glm::vec3;
using glm::vec4;

struct Triangle {
  Few<vec3, 3> corners;         // clip x, y, w: floats, as the visibility draw has them
  Few<double, 3> flushed = {};  // of a corner: how much a device may have flushed away
  double half_width = 0, half_height = 0, offset_x = 0, offset_y = 0;  // pixels; exact
};
// One corner by the surface's clip rows; the pixel and the viewport that it is in.
void set_corner(Triangle&, int k, const SurfaceRecord&, const vec3& position);
void place(Triangle&, uvec2 pixel, uvec2 viewport);

// The triangle that a pixel of the visibility buffer shows; an index past the end is the last. None: nothing is shown,
// or there is nothing.
struct ShownTriangle : Triangle {
  const SurfaceRecord* surface = nullptr;
  Few<uint32_t, 3> vertices = {};
  bool flipped = false;
};
std::optional<ShownTriangle> shown_triangle(uvec2 texel, std::span<const vec3> positions,
                                            std::span<const uint32_t> indices, std::span<const SurfaceRecord> surfaces);

// What a formula may answer. Where `determined` is false, the weights are anywhere in the simplex if clamped, the rest
// anything.
struct Hit {
  bool determined = false;
  bool clamped = true;  // the weights are kept in the simplex
  Few<RoundedDouble, 3> weights;
  Few<RoundedDouble, 4> derivatives;  // d lambda_1/dx, d lambda_2/dx, d lambda_1/dy, d lambda_2/dy
  bool clockwise = false;
};
Hit hit_compensated(const Triangle&);

// A unit vector; where not `determined`, any.
struct Direction {
  bool determined = false;
  Few<RoundedDouble, 3> xyz;
};
Direction axis(int);
struct TangentFrame {
  Direction normal, tangent;
  bool left_handed = false;
};
TangentFrame frame_of(const SurfaceRecord&, bool flipped, const Few<const VertexAttributes*, 3>&, const Hit&);

// ---- The formula's steps, which others share ----

RoundedWide exact(double);
Hit thirds();  // where there is no triangle to speak of

// Corners scaled by a power of two so that the largest coordinate is in 1..2; nothing where that is not promised, nor
// of one point thrice, where every formula subtracts equal products from each other and finds no area.
struct Corner {
  RoundedWide x, y, w;
};
std::optional<Few<Corner, 3>> scaled(const Triangle&);

// Relative to the pixel's centre, pixels times w: the corners and twice the areas times two w.
using Three = Few<RoundedWide, 3>;
struct Recentred {
  Three x, y, areas;
  RoundedWide area;  // their sum
};
Recentred recentred_by_compensation(const Triangle&, const Few<Corner, 3>&);
Hit hit_compensated(const Recentred&, const Few<Corner, 3>&);

// Weights from the three areas, derivatives from them and differences of recentred corners (y2 - y0, y0 - y1, x0 - x2,
// x1 - x0): the last steps of the formulas that clamp.
Hit weigh(const Three& areas, const RoundedWide& area, const Few<RoundedWide, 4>& differences, const Few<Corner, 3>&);

}  // namespace assay::interpolation
