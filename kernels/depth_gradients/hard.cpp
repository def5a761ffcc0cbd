// Named hard cases, and the faults that they must find.
#include <limits>

#include "kernels/depth_gradients/inputs.h"

namespace assay::depth_gradients {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN(),
                kLargest = std::numeric_limits<float>::max(), kDenormal = 1e-40f;

// One plane that all pixels show, by a triangle around the screen.
std::array<dvec2, 3> around(Extent e) {
  return {dvec2(-1.5 * e.width, -0.6 * e.height), dvec2(0.5 * e.width, 2.7 * e.height),
          dvec2(2.4 * e.width, -0.7 * e.height)};
}
Case one_plane(Extent e, const Plane& plane) {
  Picture p(e);
  p.add_surface();
  p.show_all(p.add_triangle(plane, around(e)), plane);
  return p.to_case();
}
Plane middle(Extent e, double w, const dvec2& slope) { return {{0.5 * e.width, 0.5 * e.height}, w, slope}; }

// A triangle a pixel, by what makes it.
template <class Make>
Case pixel_by_pixel(Extent e, const Make& make) {
  Picture p(e);
  p.add_surface();
  Pcg32 rng(7);
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) make(p, rng, x, y);
  return p.to_case();
}

std::array<dvec2, 3> triangle_about(Pcg32& rng, const dvec2& at, double size, double width) {
  const double a = rng.range(0, 6.283185307);
  const dvec2 along = {std::cos(a), std::sin(a)}, aside = dvec2(-along.y, along.x) * width;
  return {at + size * along, at + size * (aside - along), at - size * (aside + along)};
}

// Slopes up to a million a pixel: the plane passes the eye within a fraction of a pixel.
Case edge_on() {
  return pixel_by_pixel({32, 32}, [](Picture& p, Pcg32& rng, uint32_t x, uint32_t y) {
    const double steep = std::pow(10, rng.range(0, 6)), a = rng.range(0, 6.283185307);
    const Plane plane = {{x + 0.5, y + 0.5}, 5, dvec2(std::cos(a), std::sin(a)) * steep};
    p.show(x, y, p.add_triangle(plane, triangle_about(rng, plane.at, 0.6 / steep, 1)), plane);
  });
}

Case slopes_of(double least, double most) {
  return pixel_by_pixel({48, 48}, [=](Picture& p, Pcg32& rng, uint32_t x, uint32_t y) {
    const double a = rng.range(0, 6.283185307);
    const Plane plane = {{x + 0.5, y + 0.5},
                         std::pow(10, rng.range(-1, 3)),
                         dvec2(std::cos(a), std::sin(a)) * std::pow(10, rng.range(least, most))};
    p.show(x, y, p.add_triangle(plane, triangle_about(rng, plane.at, 0.9, 1)), plane);
  });
}

// Far from everything: triangles of a pixel and of a thousandth of one.
Case sizes(double w, double size, double width) {
  return pixel_by_pixel({48, 32}, [=](Picture& p, Pcg32& rng, uint32_t x, uint32_t y) {
    const double a = rng.range(0, 6.283185307);
    const Plane plane = {{x + 0.5, y + 0.5}, w, dvec2(std::cos(a), std::sin(a)) * std::pow(10, rng.range(-4, -1))};
    p.show(x, y, p.add_triangle(plane, triangle_about(rng, plane.at, size, width)), plane);
  });
}

// A floor from under the eye to the horizon: two corners lie behind the eye.
Case behind_the_eye() {
  const Extent e = {64, 64};
  Picture p(e);
  p.add_surface();
  const Plane floor = {{32, 64}, 1.5, {0, 1 / 32.0}};  // the horizon is in the middle
  const uint32_t triangle = p.add_triangle(floor, {dvec2(-2000, -900), dvec2(2100, -800), dvec2(40, 900)});
  for (uint32_t y = 33; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) p.show(x, y, triangle, floor);
  return p.to_case();
}

// A plane a row, by surfaces that turn it round: mirrored, instanced, axes that change places.
Case surfaces_in_turn() {
  const Extent e = {48, 48};
  Picture p(e);
  for (uint32_t row = 0; row < e.height; ++row) {
    const Plane plane = middle(e, 4, dvec2(0.01, -0.02) / (1.0 + row));
    SurfaceRecord s = {};
    s.clip_x = {1, 0, 0, 0}, s.clip_y = {0, 1, 0, 0}, s.clip_w = {0, 0, 1, 0};
    if (row % 4 == 1) s.clip_x.x = -1, s.flags = kSurfaceFlipped;
    if (row % 4 == 2) s.flags = kSurfaceInstanced;
    if (row % 4 == 3) s.clip_x = {0, 0.5f, 0, 3}, s.clip_y = {0, 0, -2, 1}, s.clip_w = {4, 0, 0, -2};
    p.add_surface(s);
    const uint32_t unused = p.add_triangle({dvec3(-9, -9, 5), dvec3(9, -9, 6), dvec3(0, 9, 7)});
    auto corners = around(e);
    if (row % 2 == 0) std::swap(corners[0], corners[1]);
    const uint32_t triangle = p.add_triangle(plane, corners);
    for (uint32_t x = 0; x < e.width; ++x) p.show(x, row, x % 16 == 15 ? unused : triangle, plane);
  }
  p.visibility[0] = {0, kVisibilityNone};  // one word all ones: the last surface's
  return p.to_case();
}

Case degenerate() {
  Picture p({16, 16});
  p.add_surface();
  const Plane level = {.w = 1};
  const dvec3 a(-0.5, -0.5, 1), b(0.5, 0.5, 1);
  const uint32_t triangles[] = {p.add_triangle({a, a, a}), p.add_triangle({a, a, b}), p.add_triangle({dvec3(0), a, b}),
                                p.add_triangle({dvec3(0), dvec3(0), dvec3(0)})};
  for (uint32_t i = 0; i < 256; ++i) p.show(i % 16, i / 16, triangles[i % 4], level);
  return p.to_case();
}

Case broken_numbers() {
  Picture p({16, 16});
  p.add_surface();
  const Plane level = {.w = 1};
  for (const float bad : {kNan, kInfinity, -kInfinity, kLargest, kDenormal, -0.0f, 1e30f, 1e-30f})
    for (int i = 0; i < 9; ++i) {
      p.add_triangle({dvec3(-1, -1, 1), dvec3(3, -1, 2), dvec3(-1, 3, 2)});
      p.positions[p.positions.size() - 3 + static_cast<size_t>(i / 3)][i % 3] = bad;
    }
  for (const float factor : {1e-28f, 1e-32f, 1e28f, 1e32f}) {
    p.add_triangle({dvec3(-1, -1, 1), dvec3(3, -1, 2), dvec3(-1, 3, 2)});
    for (size_t k = 1; k <= 3; ++k) p.positions[p.positions.size() - k] *= factor;
  }
  for (uint32_t i = 0; i < 256; ++i) p.show(i % 16, i / 16, i % p.surfaces[0].triangle_count, level);
  return p.to_case();
}

Case out_of_range() {
  Picture p({16, 16});
  p.add_surface();
  const Plane plane = middle(p.extent, 3, {0.02, 0.01});
  for (int i = 0; i < 2; ++i) p.add_triangle(plane, around(p.extent));
  p.indices[1] = 0xffffffffu;
  SurfaceRecord s = p.surfaces[0];
  s.first_index = 0xfffffffdu;
  p.surfaces.push_back(s);
  s.first_index = 1u << 20, s.vertex_offset = 0xffffffffu;
  p.surfaces.push_back(s);
  const uvec2 words[] = {{0, 0},           {1, 0},           {2, 0},           {0x55555555u, 0},
                         {0xfffffffeu, 1}, {1, 1},           {0, 0x3fffffffu}, {1, 0x7fffffffu},
                         {1, 0xbfffffffu}, {0xffffffffu, 0}, {1, 2},           {7, kVisibilityNone}};
  for (uint32_t i = 0; i < 256; ++i) p.visibility[i] = words[i % std::size(words)];
  return p.to_case();
}

Case empty_scene() {
  Picture p({16, 16});
  for (uint32_t i = 0; i < 256; ++i) p.visibility[i] = {i, i % 2};
  return p.to_case();
}

Case broken_depths() {
  const Extent e = {32, 32};
  Case c = one_plane(e, middle(e, 3, {0.01, 0.02}));
  std::vector<float> depth(pixels(c), 0.1f);
  const float odd[] = {0, kNan, kInfinity, -kInfinity, -0.5f, kDenormal, kLargest, 1e-18f};
  for (size_t i = 0; i < depth.size(); i += 3) depth[i] = odd[i / 3 % std::size(odd)];
  c.set_input("depth", depth);
  return c;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  const auto plane = [](Extent e) {
    return [e] { return one_plane(e, middle(e, 4, {0.5 / e.width, -0.2 / e.height})); };
  };
  return {
      {"wall", "square to the view: every gradient is 0 within rounding",
       [] {
         return one_plane({48, 32}, middle({48, 32}, 7, {}));
       }},
      {"slanted", "one plane by a triangle much larger than the screen", plane({48, 32})},
      {"edge_on", "the plane all but passes the eye: gradients to the largest half and beyond", edge_on},
      {"steps_of_halves", "gradients from 1e-9 to 10: halves' denormals, and each of their exponents",
       [] { return slopes_of(-9, 1); }},
      {"far", "triangles of a pixel, a million metres away", [] { return sizes(1e6, 0.8, 1); }},
      {"near", "a tenth of a millimetre away", [] { return sizes(1e-4, 0.8, 1); }},
      {"tiny", "triangles of a thousandth of a pixel", [] { return sizes(5, 1e-3, 1); }},
      {"slivers", "as narrow as a hundredth of their length", [] { return sizes(5, 30, 0.01); }},
      {"behind_the_eye", "a floor with corners behind the eye, to the horizon", behind_the_eye},
      {"surfaces_in_turn", "mirrored, instanced and turned surfaces, both windings", surfaces_in_turn},
      {"degenerate", "no area: a point, a line, the eye itself", degenerate},
      {"broken_numbers", "NaN, infinities, the largest and denormals at each coordinate in turn", broken_numbers},
      {"out_of_range", "triangles, vertices and surfaces past their ends", out_of_range},
      {"empty_scene", "a visibility buffer that names what is not there", empty_scene},
      {"nothing_seen", "no pixel shows a surface",
       [] {
         return Picture({33, 31}).to_case();
       }},
      {"broken_depths", "depths of 0, NaN, infinities and denormals beside each other", broken_depths},
      {"one_pixel", "a screen of one pixel", plane({1, 1})},
      {"one_row", "one row, one past a group", plane({17, 1})},
      {"one_column", "one column, one less than a group", plane({1, 15})},
      {"odd", "31 x 33", plane({31, 33})},
      {"1921x1081", "a row and a column more than whole groups", plane({1921, 1081}), true},
      {"3840x2160", "the largest screen that is usual", plane({3840, 2160}), true},
  };
}

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "what is beyond the largest half goes past its exponent", "edge_on"},
      {"analytic.comp", 2, "along y the other way round", "slanted"},
      {"analytic.comp", 3, "every surface is square to the view", "slanted"},
      {"analytic.comp", 4, "x and y change places", "slanted"},
      {"analytic.comp", 5, "the third vertex's area is left out", "slanted"},
      {"analytic.comp", 6, "what has no area is divided by it", "degenerate"},
      {"analytic.comp", 7, "triangles of one winding lean the other way", "slanted"},
      {"harness/glsl/half.glsl", 9116, "truncates in place of rounding", "slanted"},
      {"harness/glsl/interpolation/shown.glsl", 9113, "no surface where only one word is all ones", "surfaces_in_turn"},
      {"harness/glsl/interpolation/shown.glsl", 9114, "the instanced bit stays in the index", "surfaces_in_turn"},
      {"harness/glsl/interpolation/shown.glsl", 9115, "the vertex offset is not added", "surfaces_in_turn"},
      {"harness/glsl/interpolation/triangle.glsl", 9104, "the pixel's corner for its centre", "slanted"},
      {"harness/glsl/interpolation/rescale.glsl", 9105, "coordinates are not scaled", "broken_numbers"},
      {"harness/glsl/interpolation/products.glsl", 9106, "what the product lost is not given back", "edge_on"}};
}

}  // namespace assay::depth_gradients
