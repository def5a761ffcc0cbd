// Named hard cases; hard_hostile.cpp has the inputs that no scene should have.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "kernels/attribute_interpolation/classes.h"
#include "kernels/attribute_interpolation/inputs.h"

namespace assay::attribute_interpolation {

namespace {

using glm::dvec3;

constexpr uint32_t kSamplesOfClass = 4096;
constexpr uvec2 k2k = {2048, 2048}, kMiddle = {1024, 1024};

// ---- Clip samples ----

std::vector<HardCase> class_cases() {
  std::vector<HardCase> cases;
  for (const InputClass& k : input_classes())
    cases.push_back({std::string("class_") + k.name, k.why, [&k] { return class_case(k, kSamplesOfClass); }});
  return cases;
}

ClipSample times(const ClipSample& s, double factor) {
  const auto scaled = [factor](const vec3& v) { return vec3(dvec3(v) * factor); };
  return {scaled(s.v0), scaled(s.v1), scaled(s.v2), s.pixel, s.viewport};
}

// The first vertex in the plane of the eye, or as good as: a division by its w is infinite, overflows, is half wrong.
Case first_w(float w) {
  return clip_case("first_w", {{vec3(-1, -1, w), vec3(5, -1, 4), vec3(-1, 5, 4), kMiddle, k2k}}, 1);
}

Case powers_of_ten() {
  const ClipSample s = {vec3(-1, -1, 1), vec3(3, -1, 2), vec3(-1, 3, 2), kMiddle, k2k};
  std::vector<ClipSample> samples;
  for (const int power : {0, 12, -18, 18, -15, 28, -28}) samples.push_back(times(s, std::pow(10.0, power)));
  return clip_case("powers_of_ten", samples, 7);
}

// The centre a 1/256 px and less outside of each edge, as snapping may leave it, and on it.
Case outside_by_a_snap() {
  std::vector<ClipSample> samples;
  const uvec2 viewport = {256, 256}, pixel = {100, 60};
  const double x = pixel.x + 0.5, y = pixel.y + 0.5;
  for (const double off : {0.0, 1 / 1024.0, 1 / 256.0, 0.3})
    for (int edge = 0; edge < 3; ++edge) {
      glm::dvec2 p[] = {{x - 3, y + off}, {x + 4, y + off}, {x + 0.5, y + 5}};
      if (off == 0.3) p[2] = {x - 40, y + 1};
      vec3 v[3];
      for (int k = 0; k < 3; ++k) {
        const double w = 2 + k;
        v[(k + edge) % 3] = vec3((2 * p[k].x / viewport.x - 1) * w, (2 * p[k].y / viewport.y - 1) * w, w);
      }
      samples.push_back({v[0], v[1], v[2], pixel, viewport});
    }
  return clip_case("outside_by_a_snap", samples, 4);
}

// Heights from 1e-3 to 1e7 pixels: from where derivatives are clamped to where they are all but nothing.
Case derivative_ranges() {
  std::vector<ClipSample> samples;
  Pcg32 rng(3);
  const uvec2 viewport = {1024, 1024};
  for (double size = 1e-3; size < 2e7; size *= 1.2) {
    const double turn = rng.range(0, 6.28), c = size * std::cos(turn), s = size * std::sin(turn);
    const auto at = [&](double a, double b) {
      return vec3((a * c - b * s) * 2 / viewport.x, (a * s + b * c) * 2 / viewport.y, 1);
    };
    samples.push_back({at(-0.3, -0.4), at(1.1, -0.2), at(-0.2, 0.9), {512, 512}, viewport});
    samples.back().v0 += vec3(1 / 1024.0, 1 / 1024.0, 0), samples.back().v1 += vec3(1 / 1024.0, 1 / 1024.0, 0);
    samples.back().v2 += vec3(1 / 1024.0, 1 / 1024.0, 0);
  }
  return clip_case("derivative_ranges", samples, 16);
}

Case one(const vec3& a, const vec3& b, const vec3& c, uvec2 pixel = kMiddle, uvec2 viewport = k2k) {
  return clip_case("", {{a, b, c, pixel, viewport}}, 1);
}

std::vector<HardCase> sample_cases() {
  return {
      {"w_of_zero", "H1: a vertex with w = 0, where a projected position is NaN", [] { return first_w(0); }},
      {"w_of_1e-38", "H2: its reciprocal is near the largest float, and products with it overflow",
       [] { return first_w(1e-38f); }},
      {"w_of_minus_1e-7", "H3: a form that divides by it is wrong by half without a sign of it",
       [] { return first_w(-1e-7f); }},
      {"behind_the_eye", "H4: the ray meets the plane behind the eye, weights are fine and w is not",
       [] {
         return one(vec3(-1, -1, -2), vec3(9, -1, 8), vec3(-1, -9, -3), {1100, 1024});
       }},
      {"collinear", "H5: no area: every weight is 0 / 0",
       [] { return one(vec3(-0.5f, -0.5f, 1), vec3(0, 0, 1), vec3(0.5f, 0.5f, 1)); }},
      {"one_point", "all vertices the same",
       [] { return one(vec3(0.25f, 0.5f, 1), vec3(0.25f, 0.5f, 1), vec3(0.25f, 0.5f, 1)); }},
      {"eye_in_the_plane", "H6: the triangle is seen from its edge, w of the hit is 0",
       [] { return one(vec3(-1, 0, 1), vec3(1, 0, 1), vec3(0, 0, 3)); }},
      {"powers_of_ten", "H7: coordinates of 1e12, 1e-18, 1e18: areas are their squares", powers_of_ten},
      {"past_the_horizon",
       "H8: the next pixel lies past the horizon of a floor, a difference to it is three times too small",
       [] {
         return one(vec3(-50, 0.05f, 0.1f), vec3(50, 0.05f, 0.1f), vec3(0, 0.05f, 1000), {1920, 1080}, {3840, 2160});
       }},
      {"outside_by_a_snap", "coverage is decided on a grid: the centre may lie outside, and a weight below 0",
       outside_by_a_snap},
      {"published_vectors", "H9 to H12, H15: 80 triangles, the worst that was found of each class for each formula",
       published_vectors},
      {"derivative_ranges", "triangles of 1e-3 to 1e7 px: every exponent that derivatives are stored with",
       derivative_ranges},
  };
}

// ---- Scenes ----

// Clip x and y as they are given, w = 1; world rows that stretch each axis by another factor.
SurfaceRecord flat_surface(double shift) {
  SurfaceRecord s = {};
  s.clip_x = vec4(1, 0, 0, shift), s.clip_y = vec4(0, 1, 0, -shift), s.clip_w = vec4(0, 0, 0, 1);
  s.world_x = vec4(0, 4, 0, 0), s.world_y = vec4(1, 0, 0, 0), s.world_z = vec4(0, 0, 0.5f, 0);
  return s;
}

vec3 some_direction(Pcg32& rng) { return normalize(vec3(rng.range(-1, 1), rng.range(-1, 1), rng.range(0.1, 1))); }

// Cells of 8 px whose corners, weights and derivatives are all exact in float, so that every formula is right: what is
// wrong here is wrong about whose triangle it is, and what is written of it. Surfaces take turns: plain, mirrored,
// instanced.
Case patchwork(bool axes) {
  constexpr uint32_t kSide = 64, kCell = 8;
  SceneBuilder scene({kSide, kSide});
  Pcg32 rng(4);
  for (uint32_t cell = 0; cell < kSide * kSide / (kCell * kCell); ++cell) {
    const uint32_t column = cell % (kSide / kCell), row = cell / (kSide / kCell);
    if (column % 4 == 0) {
      SurfaceRecord s = flat_surface(0.125);
      if (row % 3 == 1) s.flags |= kSurfaceFlipped, s.world_z.z = -0.5f;
      if (row % 3 == 2) s.flags |= kSurfaceInstanced;
      scene.add_surface(s);
    }
    const auto corner = [&](uint32_t i, uint32_t j) {
      return vec3((column + i) * kCell / 32.0 - 1 - 0.125, (row + j) * kCell / 32.0 - 1 + 0.125, 0.0);
    };
    std::array<VertexAttributes, 3> a;
    for (VertexAttributes& v : a) {
      v = {axes ? vec3(1, 0, 0) : some_direction(rng), vec4(axes ? vec3(0, 1, 0) : some_direction(rng), 1), vec2(0)};
      v.tangent.w = (column + row) % 2 == 0 ? 1.0f : -1.0f;
    }
    const uint32_t first = scene.add_triangle({corner(1, 0), corner(0, 1), corner(0, 0)}, a),
                   second = scene.add_triangle({corner(1, 0), corner(0, 1), corner(1, 1)}, a);
    for (uint32_t i = 0; i < kCell * kCell; ++i) {
      const uint32_t x = i % kCell, y = i / kCell;
      scene.show(column * kCell + x, row * kCell + y, x + y + 1 < kCell ? first : second);
    }
  }
  // One word all ones and the other not: the last surface's, not no surface.
  scene.show_bits(63, 63, {7, kVisibilityNone});
  scene.show_bits(62, 63, {kVisibilityNone, kVisibilityNone});
  return scene.finish("patchwork");
}

// Normals and tangents that lie in the equator of the projection, or by 2^-k beside it, and at its pole.
Case equator() {
  SceneBuilder scene({24, 16});
  SurfaceRecord s = flat_surface(0);
  s.world_x = vec4(1, 0, 0, 0), s.world_y = vec4(0, 1, 0, 0), s.world_z = vec4(0, 0, 1, 0);
  scene.add_surface(s);
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 24; ++x) {
      const uint32_t quarter = y / 4;
      const double phi = quarter * 1.5707963267948966 + (y % 4 == 0   ? 0
                                                         : y % 4 == 1 ? 1e-3
                                                         : y % 4 == 2 ? -1e-3
                                                                      : 0.785);
      const double z = (y % 2 == 0 ? 1 : -1) * std::ldexp(1.0, -1 - static_cast<int>(x));
      vec3 n = normalize(vec3(std::cos(phi), std::sin(phi), z)), t = normalize(vec3(-std::sin(phi), std::cos(phi), -z));
      if (x == 23) n = vec3(std::cos(phi), std::sin(phi), y % 2 == 0 ? 0.0 : -0.0), t = vec3(0, 0, y % 2 == 0 ? 1 : -1);
      if (x == 22 && y % 4 == 0) n = vec3(y / 4 == 0, y / 4 == 1, y / 4 == 2 ? 1 : 0), t = vec3(0, y / 4 != 1, 0);
      const VertexAttributes v = {n, vec4(t, x % 2 == 0 ? 1 : -1), vec2(0)};
      const uint32_t triangle = scene.add_triangle({vec3(-1, -1, 0), vec3(3, -1, 0), vec3(-1, 3, 0)}, {v, v, v});
      scene.show(x, y, triangle);
    }
  return scene.finish("equator");
}

// Triangles of a class, in object space, `reach` metres from the object's origin; the object `away` metres from the
// eye.
Case object_space(const char* name, double reach, double away, const glm::dvec3& camera) {
  SceneBuilder scene({96, 64});
  Pcg32 rng(5);
  const glm::dvec3 object = camera + glm::dvec3(0.1, -0.2, -1) * away;
  // Camera-relative, the difference in double.
  scene.add_surface(glm::rotate(glm::translate(glm::dmat4(1), object - camera), 0.5, glm::dvec3(0.6, 0.8, 0)));
  const InputClass& k = input_class("single_sample");
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 96; ++x) {
      ClipSample s = k.make(rng, {x, y}, {96, 64});
      const double scale = (away + rng.range(-reach, reach)) / s.v0.z;
      std::array<vec3, 3> p;
      const vec3 corners[] = {s.v0, s.v1, s.v2};
      for (size_t i = 0; i < 3; ++i) p[i] = scene.object_position(dvec3(corners[i]) * scale);
      const VertexAttributes v = flat_attributes();
      scene.show(x, y, scene.add_triangle(p, {v, v, v}));
    }
  return scene.finish(name);
}

Case with_extent(uint32_t width, uint32_t height) { return typical({width, height}); }

std::vector<HardCase> scene_cases() {
  return {
      {"patchwork", "every formula is exact here: surfaces, offsets, flags and encodings are not",
       [] { return patchwork(false); }},
      {"patchwork_flags", "directions along axes, z = 0: signs of zero, mirrors and hands",
       [] { return patchwork(true); }},
      {"equator", "z of 2^-k and of both zeros: where two numbers and a sign tell least of a direction", equator},
      {"camera_at_1e6_m", "H14: world positions in float are off by 180 px there; differences in double are not",
       [] {
         return object_space("camera_at_1e6_m", 1, 20, {1e6, 3e5, 7e5});
       }},
      {"meshes_of_100_m", "H16: triangles of a pixel on a mesh of 100 m, whose positions round to 4 um",
       [] {
         return object_space("meshes_of_100_m", 80, 120, {0, 0, 0});
       }},
      {"one_pixel", "a viewport of one pixel", [] { return with_extent(1, 1); }},
      {"one_row", "one row, one past a group", [] { return with_extent(17, 1); }},
      {"group_less_one", "one less than a group a side", [] { return with_extent(15, 15); }},
      {"group", "a group", [] { return with_extent(16, 16); }},
      {"group_and_one", "one more than a group a side", [] { return with_extent(17, 17); }},
      {"odd", "31 x 33", [] { return with_extent(31, 33); }},
      {"1921x1081", "a row and a column more than whole groups", [] { return with_extent(1921, 1081); }, true},
      {"3840x2160", "the size that the goals speak of", [] { return with_extent(3840, 2160); }, true},
      {"no_surface", "a screen that shows nothing",
       [] {
         return SceneBuilder({33, 31}).finish("no_surface");
       }},
  };
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases = sample_cases();
  for (const auto& more : {scene_cases(), class_cases(), hostile_cases()})
    cases.insert(cases.end(), more.begin(), more.end());
  return cases;
}

}  // namespace assay::attribute_interpolation
