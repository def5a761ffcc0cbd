// Named hard cases; hard_masked.cpp has the rest.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "kernels/visibility/hard.h"

namespace assay::visibility {

glm::dmat4 flat_rows() { return glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1); }

vec3 flat_at(Extent e, double x, double y) { return vec3(2 * x / e.width - 1, 2 * y / e.height - 1, 0); }

Case flat_case(Extent e, const std::vector<glm::dvec2>& pixels, const std::vector<uint32_t>& indices,
               const Look& look) {
  SceneBuilder scene(e);
  Mesh m;
  for (const glm::dvec2& p : pixels) add_vertex(m, flat_at(e, p.x, p.y), vec2(p.x / e.width, p.y / e.height));
  m.indices = indices;
  scene.add_rows(m, look, flat_rows());
  return scene.finish();
}

Case space_case(Extent e, const std::vector<vec3>& positions, const Look& look) {
  SceneBuilder scene(e);
  Mesh m;
  for (size_t i = 0; i < positions.size(); ++i)
    m.indices.push_back(add_vertex(m, positions[i], vec2(i & 1u, i >> 1 & 1u)));
  scene.add(m, look);
  return scene.finish();
}

Look masked_look(float factor, float cutoff, uint32_t texture) {
  Look look;
  look.material = {vec4(1, 1, 1, factor), texture, cutoff, kMaterialMasked, 0};
  return look;
}

Look both_sides() {
  Look look;
  look.material.flags = kMaterialDoubleSided;
  return look;
}

Mesh quad_mesh(float size) {
  Mesh m;
  add_grid(m, 1, 1, [size](float u, float v) { return vec3(size * (2 * u - 1), size * (2 * v - 1), 0); });
  return m;
}

namespace {

constexpr Extent kSquare = {64, 64};

// Clip coordinates as they are: x, y are the position's, and w is a row of its own.
Case clip_case(Extent e, const std::vector<vec3>& xyw) {
  SceneBuilder scene(e);
  Mesh m;
  for (const vec3& v : xyw) m.indices.push_back(add_vertex(m, v, vec2(v.x, v.y)));
  scene.add_rows(m, both_sides(), glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0));
  return scene.finish();
}

std::vector<HardCase> coverage_cases() {
  return {
      {"full_screen", "one triangle over everything: nothing but the sides of the screen cuts it",
       [] {
         return flat_case({131, 67}, {{0, 0}, {0, 134}, {262, 0}}, {0, 1, 2});
       }},
      {"flat_quad", "a diagonal through pixel centres: each is covered once, by the top-left rule",
       [] {
         return flat_case(kSquare, {{0, 0}, {0, 64}, {64, 0}, {64, 64}}, {0, 1, 2, 2, 1, 3});
       }},
      {"edges_on_centres",
       "four edges along rows and columns of pixel centres: top and left are in, bottom and right out",
       [] {
         return flat_case(kSquare, {{8.5, 8.5}, {8.5, 40.5}, {40.5, 8.5}, {40.5, 40.5}}, {0, 1, 2, 2, 1, 3});
       }},
      {"vertex_on_centre", "six triangles meet on a pixel's centre, and one of them has it",
       [] {
         return flat_case(kSquare, {{20.5, 20.5}, {30, 20.5}, {25, 12}, {15, 12}, {10, 20.5}, {15, 30}, {25, 30}},
                          {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1});
       }},
      {"slivers", "triangles thinner than the sub-pixel grid: what is left of them decides, or nothing",
       [] {
         std::vector<glm::dvec2> p;
         std::vector<uint32_t> indices;
         for (uint32_t i = 0; i < 30; ++i) {
           const double y = 1.5 + 2 * i, thin = std::ldexp(1.0, -static_cast<int>(i) / 2);
           for (const glm::dvec2 v : {glm::dvec2(1.25, y), {62.75, y + thin}, {62.75, y - 0.3 * thin}}) p.push_back(v);
           indices.insert(indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
         }
         return flat_case(kSquare, p, indices, both_sides());
       }},
      {"degenerate", "three vertices in a line, and three in a point: no area, so nothing",
       [] {
         return flat_case(kSquare, {{4, 4}, {20, 20}, {36, 36}, {9.5, 9.5}}, {0, 1, 2, 3, 3, 3, 0, 1, 1}, both_sides());
       }},
      {"between_centres", "triangles that hold no pixel's centre leave no trace",
       [] {
         return flat_case(
             kSquare,
             {{10.625, 10.625}, {10.625, 11.375}, {11.375, 10.625}, {20.5, 20.75}, {20.25, 21.25}, {20.75, 21.25}},
             {0, 1, 2, 3, 4, 5}, both_sides());
       }},
      {"facing", "one triangle seen from the front, one from behind, both single-sided: the first stays",
       [] {
         return flat_case(kSquare, {{4, 4}, {4, 40}, {40, 4}, {60, 60}, {60, 20}, {20, 60}}, {0, 1, 2, 3, 5, 4});
       }},
      {"guard_band", "vertices 16,384 pixels out: fixed-point set-up runs out of bits, or clips",
       [] {
         return flat_case(kSquare, {{-16384, -16000}, {-15000, 16384}, {16384, 31.3}, {20, -16384}}, {0, 1, 2, 0, 2, 3},
                          both_sides());
       }},
      {"beyond_guard_band", "vertices millions of pixels out must be clipped",
       [] {
         return flat_case(kSquare, {{-4e6, -3e6}, {30, 5e6}, {4e6, 31.3}}, {0, 1, 2}, both_sides());
       }},
      {"one_pixel", "a screen of 1 x 1",
       [] {
         return flat_case({1, 1}, {{-1, -1}, {-1, 3}, {3, -1}}, {0, 1, 2});
       }},
      {"nothing", "an empty draw list: clears alone must fill the targets",
       [] {
         return SceneBuilder({33, 31}).finish();
       }},
  };
}

std::vector<HardCase> depth_cases() {
  return {
      {"same_twice", "one triangle drawn twice: equal depth, so the first stays",
       [] {
         return space_case(kSquare,
                           {{-1, -1, -2}, {1, -1, -3}, {0, 1, -2.5f}, {-1, -1, -2}, {1, -1, -3}, {0, 1, -2.5f}});
       }},
      {"tie_at_one_depth", "different triangles at exactly the same depth, w = 1: the first drawn wins everywhere",
       [] {
         return flat_case(kSquare, {{0, 0}, {10, 60}, {60, 10}, {2, 50}, {50, 60}, {40, 0}}, {0, 1, 2, 3, 4, 5},
                          both_sides());
       }},
      {"crossing_planes", "two triangles through each other: the nearer one changes along a line",
       [] {
         return space_case({97, 61}, {{-2, -1, -2}, {2, -1, -4}, {0, 1, -3}, {-2, -1, -4}, {2, -1, -2}, {0, 1, -3}},
                           both_sides());
       }},
      {"nearest_last", "a stack drawn from far to near, then from near to far",
       [] {
         std::vector<vec3> p;
         for (int i = 0; i < 16; ++i) {
           const float z = -3 - 0.125f * static_cast<float>(i < 8 ? 8 - i : i - 8);
           for (const vec3 v : {vec3(-1, -1, z), vec3(1, -1, z), vec3(i < 8 ? -1 : 1, 1, z)}) p.push_back(v);
         }
         return space_case({70, 70}, p);
       }},
      {"far_away", "10^7 near distances: depth near 10^-7, where fixed point would be all zeros",
       [] {
         return space_case({65, 65}, {{-1e6f, -1e6f, -1e6f}, {1e6f, -1e6f, -1.25e6f}, {0, 1e6f, -1.1e6f}});
       }},
  };
}

std::vector<HardCase> near_cases() {
  return {
      {"vertex_at_eye", "w = 0 at a vertex: its direction is everywhere (w exactly zero)",
       [] {
         return clip_case({128, 128}, {{-1, -1, 0}, {5, -1, 4}, {-1, 5, 4}});
       }},
      {"vertex_w_tiny", "w of 1e-38 overflows a reciprocal",
       [] {
         return clip_case({128, 128}, {{-1, -1, 1e-38f}, {5, -1, 4}, {-1, 5, 4}});
       }},
      {"vertex_w_minus", "w barely negative",
       [] {
         return clip_case({128, 128}, {{-1, -1, -1e-7f}, {5, -1, 4}, {-1, 5, 4}});
       }},
      {"two_behind", "two vertices behind the eye: the third edge must not appear reflected",
       [] {
         return clip_case({128, 128}, {{-1, -1, -2}, {9, -1, 8}, {-1, -9, -3}});
       }},
      {"all_behind", "a triangle behind the eye is not drawn",
       [] {
         return clip_case(kSquare, {{-1, -1, -2}, {1, -1, -2}, {0, 1, -3}});
       }},
      {"eye_in_plane", "seen edge-on through the eye: no area",
       [] {
         return clip_case(kSquare, {{-1, 0, 1}, {1, 0, 1}, {0, 0, 3}});
       }},
      {"on_near_plane", "w exactly the near distance is inside, at depth 1",
       [] {
         return clip_case(kSquare, {{-0.125f, -0.125f, kNear}, {0.125f, -0.125f, kNear}, {0, 0.125f, kNear}});
       }},
      {"before_near_plane", "w one ulp below the near distance is clipped away",
       [] {
         const float w = std::nextafter(kNear, 0.0f);
         return clip_case(kSquare, {{-0.125f, -0.125f, w}, {0.125f, -0.125f, w}, {0, 0.125f, w}});
       }},
      {"floor_to_horizon", "a floor from behind the eye to a kilometre ahead",
       [] {
         return space_case({160, 90}, {{-500, -1.5f, 10}, {500, -1.5f, 10}, {0, -1.5f, -1000}});
       }},
      {"large_scale", "clip coordinates of 10^12: squares overflow float",
       [] {
         return clip_case({128, 128}, {{-1e12f, -1e12f, 1e12f}, {3e12f, -1e12f, 2e12f}, {-1e12f, 3e12f, 2e12f}});
       }},
  };
}

std::vector<HardCase> instance_cases() {
  const auto places = [](uint32_t count, bool mirrored) {
    std::vector<glm::dmat4> all;
    for (uint32_t i = 0; i < count; ++i) {
      const double side = std::ceil(std::sqrt(count)), x = i % static_cast<uint32_t>(side), y = std::floor(i / side);
      glm::dmat4 place =
          glm::translate(glm::dmat4(1), glm::dvec3(4 * (x + 0.5) / side - 2, 4 * (y + 0.5) / side - 2, -2.5));
      place = glm::scale(place, glm::dvec3(1.7 / side));
      all.push_back(mirrored ? glm::scale(place, glm::dvec3(-1, 1, 1)) : place);
    }
    return all;
  };
  const auto quads = [places](uint32_t count, bool mirrored, Look look) {
    SceneBuilder scene({200, 150});
    look.instanced = count > 1;
    scene.add(quad_mesh(1), look, places(count, mirrored));
    return scene.finish();
  };
  return {
      {"instances", "four instances of one draw: each pixel names its own", [quads] { return quads(4, false, {}); }},
      {"instances_4096", "4096 instances of one draw, two pixels each", [quads] { return quads(4096, false, {}); }},
      {"mirrored", "a mirroring transform flips the winding: flagged, and culled the other way round",
       [quads] { return quads(1, true, {}); }},
      {"mirrored_instances", "both flags at once", [quads] { return quads(9, true, {}); }},
      {"mirrored_both_sides", "mirrored and double-sided: nothing is culled, the flag stays",
       [quads] { return quads(1, true, both_sides()); }},
      {"every_bucket", "opaque and masked, each way of facing: six pipelines in one pass",
       [places] {
         SceneBuilder scene({120, 120});
         const auto all = places(6, false);
         for (uint32_t i = 0; i < 6; ++i) {
           Look look;
           if (i % 3 == 2) look.material.flags |= kMaterialDoubleSided;
           if (i >= 3) look.material.flags |= kMaterialMasked;
           scene.add(quad_mesh(1), look, {i % 3 == 1 ? glm::scale(all[i], glm::dvec3(-1, 1, 1)) : all[i]});
         }
         return scene.finish();
       }},
  };
}

std::vector<HardCase> size_cases() {
  std::vector<HardCase> cases;
  for (const Extent e : {Extent{1, 1}, {2, 1}, {31, 33}, {32, 32}, {33, 31}, {255, 257}, {1921, 1081}, {3840, 2160}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }, e.width > 1000});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more :
       {coverage_cases(), depth_cases(), near_cases(), instance_cases(), masked_cases(), hostile_cases(), size_cases()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace assay::visibility
