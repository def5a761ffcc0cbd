// Which pixels a triangle covers, three-valued, by the top-left rule on the device's sub-pixel grid.
#pragma once
#include <array>
#include <vector>

#include "harness/raster/clip.h"

namespace assay::raster {

enum class Cover { out, maybe, in };

// An edge of the visible polygon, directed as the rasteriser walks it with the interior on its positive side.
struct Edge {
  double ax = 0, ay = 0, bx = 0, by = 0;  // pixels
  double a_moved = 0, b_moved = 0;        // how far either end may be from there, in either coordinate
  uint32_t from = 0, to = 0;              // the triangle's vertices that it joins
  bool inclusive = false;                 // a top or a left edge: owns the points on it
};

// A linear function of pixel coordinates, about the shape's origin.
struct Plane {
  double at_origin = 0, d_dx = 0, d_dy = 0;
};

struct Point {
  double x = 0, y = 0;
};

// Rounding of plane evaluation is u * (x * |d_dx| + y * |d_dy|), pixels.
struct Rounding {
  double x = 0, y = 0;
};
// A triangle that a device may make of what is left of one that was cut; its plane may be worse than the whole's.
struct Piece {
  std::array<Point, 3> corners = {};
  Rounding rounding = {};
  double moved = 0;   // the most that a corner may be moved, pixels
  double height = 0;  // the least that is then left, pixels
  bool known = true;  // false: it is so thin that its planes are all cancellation
};

// A triangle as the rasteriser sees it: what lies between the near and the far plane, inside the target.
struct Shape {
  std::vector<Edge> edges;    // one set of 1 to 3 for each admissible orientation
  uint32_t edges_a_side = 0;  // edges of a set
  bool certain = true;        // false: nothing is sure to be covered (facing unknown, positions unknown)
  bool anywhere = false;      // a corner is at infinity: nothing at all is sure
  bool whole = false;         // no plane of the view cuts it
  bool crosses_near = false;  // whether the depth is at most 1 decides too
  bool crosses_far = false;   // or at least 0
  double cut_slack = 0;       // of depth, where one of them is crossed
  uint32_t x_first = 0, y_first = 0, x_end = 0, y_end = 0;  // pixels outside are not covered
  double left = 0, top = 0, right = 0, bottom = 0;          // the target's sides
  double side_moved = 0;                                    // how far from them a cut may be, pixels
  double origin_x = 0, origin_y = 0;                        // of the planes
  std::array<Plane, 3> weights = {};  // perspective weights times 1/w, one a vertex; their sum is 1/w
  Plane inverse_w = {}, depth = {};
  double moved = 0;           // the most that a corner may be moved, pixels
  double near_moved = 0;      // likewise of corners on the near plane
  double height = 0;          // the least that the moved triangle has, pixels
  double stretch = 1;         // how far moved corners may extrapolate: sum of the weights' magnitudes
  double relative_error = 0;  // of 1/w at the corners
  double z_error = 0;         // of depth at the corners, beside that
  Rounding rounding = {};
  std::vector<Piece> pieces = {};  // of one that is cut
  bool planes_known = true;        // false: nothing is known of interpolated values
};

enum class Facing { cull_back, cull_front, both };

// Empty edges: nothing to draw.
Shape shape_of(const std::array<ClipVertex, 3>&, Facing, const Target&);
constexpr uint32_t kNoEdge = 0xffffffffu;
struct Coverage {
  Cover cover = Cover::out;
  uint32_t only_doubt = kNoEdge;  // the only edge that leaves it undecided, if one does
};
// Of the pixel's centre, by the edges.
Coverage covers(const Shape&, double x, double y);
// Of a shape that crosses the near or the far plane: whether the pixel's centre lies between them.
Cover in_depth(const Shape&, double x, double y);

// An interval of a linear function's fp32 evaluation at a pixel centre.
struct Interval {
  double low = 0, high = 0;
};
// z / w as rasterised. A float depth buffer is not clamped: rounding may pass 1 at the near plane.
Interval depth_at(const Shape&, double x, double y);
// The greatest float that is no greater, the least that is no less.
float float_at_most(double);
float float_at_least(double);
double evaluate(const Shape&, const Plane&, double x, double y);
// Sum of the weights' magnitudes at a point that the device may see up to `outside` pixels beside the triangle, or the
// piece of it that holds the pixel.
double stretch_at(const Shape&, double outside, double x, double y);
// What fp32 evaluation of a plane may be off at a pixel, infinite where nothing is known.
double rounding_of(const Shape&, const Plane&, double value, double x, double y);
// How far what is seen at a pixel of this depth may be moved: a corner on the near plane has at most the depth's
// weight, as the weighted sum of the corners' depths is the pixel's, and its own is 1.
double moved_at(const Shape&, double depth);

}  // namespace assay::raster
