// Named hard cases, and the faults that they must find.
#include <cmath>
#include <limits>

#include "kernels/shadow_lookup/inputs.h"

namespace assay::shadow_lookup {

using glm::dvec3;
using shadowing::Caster;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr uint32_t kSide = 32;
const dvec3 kNoPlane = {}, kDown = {0, 0, -1};

std::function<Case()> made(std::function<Setup()> make) {
  return [make = std::move(make)] { return to_case(make()); };
}

// A spot at the origin that looks along -z, 90 degrees across, in the middle one of nine tiles; the others are full of
// the nearest depth, its own of this one.
Setup spot(float depth, uint32_t side = kSide) {
  Setup s = {shadowing::Atlas({3 * side, 3 * side})};
  s.atlas.fill({0, 0, 3 * side}, 1);
  const ShadowTile tile = {side, side, side};
  s.atlas.fill(tile, depth);
  s.add_light(kLightSpot, {}, kDown, s.atlas.add_spot(tile, {}, kDown, std::atan(1.0), 0.125, 20), 1);
  return s;
}
// Where that spot's tile has (x, y), w metres along.
dvec3 before_spot(double x, double y, double w) { return {x * w, -y * w, -w}; }

// A sun along -z with cascades of 4, 8, 16, 32 metres to each side, of which every other one is in shadow.
Setup sun(uint32_t cascades) {
  Setup s = {shadowing::Atlas({kSide * cascades, kSide})};
  for (uint32_t i = 0; i < cascades; ++i) {
    const ShadowTile tile = {i * kSide, 0, kSide};
    s.atlas.add_cascade(tile, {}, kDown, 4 << i, 10, 60);
    s.atlas.fill(tile, i % 2 ? 0 : 0.9f);
  }
  s.add_light(kLightDirectional, {}, kDown, 0, cascades);
  return s;
}

// A lamp at the origin whose faces hold nothing, or what hides all beyond half a metre, in turn.
Setup lamp() {
  Setup s = {shadowing::Atlas({kCubeFaces * kSide, kSide})};
  s.add_light(kLightPoint, {}, {}, s.atlas.add_cube({0, 0, kSide}, {}, 0.125, 20), kCubeFaces);
  for (uint32_t face = 0; face < kCubeFaces; ++face)
    s.atlas.fill({face * kSide, 0, kSide}, face == 0 || face == 3 || face == 4 ? 0.25f : 0);
  return s;
}

// ---- On the planes that were drawn ----

// The angle between a light's ray to a point and a plane, its sine.
double sine_to(const LightRecord& l, const dvec3& p, const dvec3& normal) {
  const dvec3 ray = l.kind == kLightDirectional ? dvec3(l.direction) : p - dvec3(l.position);
  return std::fabs(glm::dot(glm::normalize(ray), glm::normalize(normal)));
}

// Lights of a kind far from the eye, each before a plane of its own that leans by up to 87 degrees from across; all
// that it lights is on that plane.
void add_planes(Setup& s, Pcg32& rng, uint32_t row, double half_rad) {
  constexpr double kLeans[] = {0, 20, 45, 60, 75, 83, 86, 87};
  const dvec3 position = {7, 5, -9}, direction = dvec3(vec3(glm::normalize(dvec3(-0.3, -0.8, 0.5))));
  for (uint32_t i = 0; i < 8; ++i) {
    const ShadowTile tile = {i * kSide, row * kSide, kSide};
    const double lean = kLeans[i] * 0.017453292519943295, turn = rng.range(0, 6.28);
    const dvec3 side = glm::normalize(glm::cross(direction, dvec3(std::cos(turn), 0.3, std::sin(turn))));
    const Caster plane = {position + 4.0 * direction,
                          std::cos(lean) * glm::normalize(direction) + std::sin(lean) * side};
    const bool is_sun = half_rad == 0;
    const uint32_t view = is_sun ? s.atlas.add_cascade(tile, plane.centre, direction, 6, 30, 30)
                                 : s.atlas.add_spot(tile, position, direction, half_rad, 0.25, 30);
    const uint32_t light = s.add_light(is_sun ? kLightDirectional : kLightSpot, position, direction, view, 1);
    s.atlas.draw(view, plane);
    for (uint32_t n = 0; n < 400; ++n) {
      const auto p = shadowing::point_on(s.atlas.views[view], rng.range(-0.75, 0.75), rng.range(-0.75, 0.75), plane);
      if (p && sine_to(s.lights[light], *p, plane.normal) > 1.05 * kLeastShadowFacing)
        s.receive(light, *p, n % 2 ? plane.normal : -plane.normal);
    }
  }
}

Setup on_the_plane() {
  Setup s = {shadowing::Atlas({8 * kSide, 3 * kSide})};
  Pcg32 rng(5);
  add_planes(s, rng, 0, 0.785398);
  add_planes(s, rng, 1, 0.1);
  add_planes(s, rng, 2, 0);
  return s;
}

std::vector<HardCase> plane_cases() {
  return {
      {"on_the_plane", "receivers on the very planes in the map, of all slopes: wholly lit, not a tap in shadow",
       made(on_the_plane)},
      {"on_a_plane_of_no_normal", "the same without the plane: half of the taps are in shadow", made([] {
         Setup s = on_the_plane();
         for (Receiver& r : s.receivers) r.plane_normal = vec3(0);
         return s;
       })},
      {"in_line", "planes in line with the light, and nearly: no slope, not an infinite one", made([] {
         Setup s = spot(0.25f);
         for (uint32_t i = 0; i < 256; ++i) {
           const dvec3 p = before_spot(i / 140.0 - 0.9, 0.1, 0.5 + 0.01 * i), across = glm::cross(p, dvec3(0, 1, 0.2));
           s.receive(0, p, glm::normalize(across) + (i % 16 * 0.004) * glm::normalize(p));
         }
         s.receive(0, {0, 0, -2}, {1, 0, 0});
         s.receive(0, {0, 0, -2}, {0, 1, 0});
         return s;
       })},
      {"across_a_step", "half of the tile is near, half far: every share between, in steps of a hundredth texel",
       made([] {
         Setup s = spot(0);
         for (uint32_t y = 0; y < kSide; ++y)
           s.atlas.fill({kSide + kSide / 2, kSide + y, 1}, 0.5f),
               s.atlas.fill({kSide + kSide / 2 + y % 8, kSide + y, 1}, 0.5f);
         for (uint32_t i = 0; i < 800; ++i)
           s.receive(0, before_spot((i - 400) / 1600.0, i % 32 / 16.0 - 0.95, 2), {0, 0, 1});
         return s;
       })},
  };
}

// ---- Which view ----

std::vector<HardCase> view_cases() {
  return {
      {"no_views", "lights without shadows, and without views of a buffer", made([] {
         Setup s = {shadowing::Atlas({1, 1})};
         s.atlas.fill({0, 0, 1}, 1);
         for (uint32_t kind = 0; kind < 4; ++kind) s.receive(s.add_light(kind, {}, kDown, 0, 0), {0, 0, -2}, {0, 0, 1});
         s.receive(s.add_light(kLightSpot, {}, kDown, 0, 1), {0, 0, -2}, {0, 0, 1});
         s.receive(99, {0, 0, -2}, {0, 0, 1});
         return s;
       })},
      {"every_face", "the middle of each face and its four quarters", made([] {
         Setup s = lamp();
         for (uint32_t i = 0; i < 6 * 25; ++i) {
           dvec3 p(2, (i / 6 % 5 - 2.0) * 0.7, (i / 30 - 2.0) * 0.7);
           if (i % 2) p = -p;
           s.receive(0, i % 6 / 2 == 0 ? p : i % 6 / 2 == 1 ? dvec3(p.z, p.x, p.y) : dvec3(p.y, p.z, p.x), kNoPlane);
         }
         return s;
       })},
      {"cube_edges", "directions along the edges and corners of the cube, on them and beside by a float: either face",
       made([] {
         Setup s = lamp();
         for (uint32_t i = 0; i < 27; ++i) {
           const dvec3 corner = {i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
           for (const double nudge : {0.0, 1e-7, -1e-7, 1e-3, -1e-3})
             for (const double away : {1.0, 3.0})
               s.receive(0, away * (corner + nudge * dvec3(1, 0.5, 0.25)),
                         i % 2 ? glm::normalize(corner + dvec3(0, 0, 0.1)) : kNoPlane);
         }
         return s;
       })},
      {"cascade_borders", "rims of each cascade at dithers from 0 to 1: just held, just not, past the last", made([] {
         Setup s = sun(kMostCascades);
         for (uint32_t cascade = 0; cascade < 4; ++cascade)
           for (uint32_t i = 0; i <= 60; ++i)
             for (const double dither : {0.0, 0.3, 0.7, 0.99999994}) {
               const double at = (4 << cascade) * (0.7 + 0.006 * i);
               s.receive(0, {at, 0.3, -i * 0.1}, kNoPlane, dither);
               s.receive(0, {0.1, -at, -i * 0.1}, {0, 0, 1}, dither);
             }
         return s;
       })},
      {"five_cascades", "a sun with more views than cascades: the fifth is not looked at", made([] {
         Setup s = sun(5);
         for (uint32_t i = 0; i < 100; ++i) s.receive(0, {i * 0.7, 0, 0}, {0, 0, 1});
         return s;
       })},
      {"views_past_the_end", "first views at and past the end, counts that reach beyond it, and past 2^32", made([] {
         Setup s = lamp();
         const uint32_t firsts[] = {0, 3, 5, 6, 7, 0xffffffffu, 0xfffffffdu}, counts[] = {1, 4, 6, 0xffffffffu};
         for (const uint32_t first : firsts)
           for (const uint32_t count : counts)
             for (uint32_t kind = 0; kind < 4; ++kind) {
               const uint32_t light = s.add_light(kind, {}, kDown, first, count);
               for (const dvec3 p :
                    {dvec3(2, 0.1, 0.2), {-2, 0.1, 0.2}, {0.1, 2, 0.2}, {0.1, -2, 0.2}, {0.1, 0.2, 2}, {0.1, 0.2, -2}})
                 s.receive(light, p, kNoPlane);
             }
         return s;
       })},
  };
}

// ---- The tile ----

std::vector<HardCase> tile_cases() {
  return {
      {"tile_borders", "filters that reach over each side of the tile, into neighbours full of the nearest depth",
       made([] {
         Setup s = spot(0.01f);
         for (uint32_t i = 0; i < 400; ++i)
           for (const double rim : {-1.0, 1.0}) {
             const double at = rim * (0.8 + 0.0006 * i);
             s.receive(0, before_spot(at, 0.3, 3), {0, 0, 1});
             s.receive(0, before_spot(0.2, at, 3), {0.2, 0, 1});
           }
         return s;
       })},
      {"one_texel", "a tile of one texel, and of two: every tap is clamped", made([] {
         Setup s = spot(0.05f, 1);
         for (uint32_t i = 0; i < 50; ++i)
           s.receive(0, before_spot(i / 25.0 - 1, 0.1, 1 + 0.1 * i), i % 2 ? kNoPlane : dvec3(0.1, 0.2, 1));
         s.atlas.views.push_back(s.atlas.views[0]);
         s.atlas.views.back().tile = {0, 0, 2};
         const uint32_t light = s.add_light(kLightSpot, {}, kDown, 1, 1);
         for (uint32_t i = 0; i < 50; ++i) s.receive(light, before_spot(i / 25.0 - 1, 0.1, 1 + 0.1 * i), {0, 0, 1});
         const uint32_t small_sun =
             s.add_light(kLightDirectional, {}, kDown, s.atlas.add_cascade({1, 1, 1}, {}, kDown, 4, 10, 9), 1);
         s.receive(small_sun, {0, 0, 0}, {0, 0, 1});
         return s;
       })},
      {"tile_past_the_atlas", "tiles that begin or end past it, of no side, of 2^32 - 1", made([] {
         Setup s = spot(0.25f);
         const uint32_t wide = s.atlas.extent.width, past = 0xffffffffu;
         for (const ShadowTile tile : {ShadowTile{wide, 0, kSide},
                                       {wide - kSide + 1, 0, kSide},
                                       {0, wide - kSide + 1, kSide},
                                       {0, 0, 0},
                                       {0, 0, past},
                                       {past, past, 2},
                                       {past - 1, 0, kSide},
                                       {0, 0, wide},
                                       {0, 0, wide + 1}}) {
           s.atlas.views.push_back(s.atlas.views[0]);
           s.atlas.views.back().tile = tile;
           const auto view = static_cast<uint32_t>(s.atlas.views.size()) - 1;
           s.receive(s.add_light(kLightSpot, {}, kDown, view, 1), {0.1, 0.2, -2}, {0, 0, 1});
           s.receive(s.add_light(kLightDirectional, {}, kDown, view, 1), {0.1, 0.2, -0.5}, {0, 0, 1});
         }
         return s;
       })},
      {"all_lit_and_all_dark", "maps of nothing, and of the nearest depth everywhere", made([] {
         Setup s = spot(0);
         const uint32_t dark = s.atlas.add_spot({0, 0, kSide}, {}, kDown, std::atan(1.0), 0.125, 20);
         s.add_light(kLightSpot, {}, kDown, dark, 1);
         for (uint32_t i = 0; i < 200; ++i)
           s.receive(i % 2, before_spot(i / 110.0 - 0.9, 0.7 - i / 150.0, 1 + 0.1 * i), {0, 0.3, 1});
         return s;
       })},
  };
}

// ---- Where a view does not see, and what is no number ----

std::vector<HardCase> unseen_cases() {
  return {
      {"behind_the_light", "w below 0, 0 and next to it; nearer than the near plane, on it; the light's own place",
       made([] {
         Setup s = spot(0.5f);
         for (const double w : {-3.0, -1e-3, -1e-30, 0.0, 1e-30, 1e-3, 0.1, 0.124, 0.126, 0.2, 0.3, 20.0})
           for (const double x : {0.0, 0.4, -0.9})
             s.receive(0, {x * std::fabs(w), 0.1 * w, -w}, {0, 0.1, 1}), s.receive(0, {x, 0, -w}, kNoPlane);
         return s;
       })},
      {"beyond_the_far_plane", "a sun's map ends before the receiver: dark where it holds a caster, else lit", made([] {
         Setup s = sun(1);
         s.atlas.fill({8, 8, 16}, 0);
         for (uint32_t i = 0; i < 200; ++i)
           s.receive(0, {i / 30.0 - 3.3, 0.2, -4 - i * 0.1}, i % 3 ? dvec3(0.9, 0.1, 0.4) : kNoPlane);
         return s;
       })},
      {"outside_the_cone", "past the tile's sides up to twice as far, and beyond", made([] {
         Setup s = spot(0.25f);
         for (uint32_t i = 0; i < 300; ++i) s.receive(0, before_spot(0.9 + 0.005 * i, -0.02 * i, 2), {0, 0.2, 1});
         return s;
       })},
      {"no_numbers", "NaN, infinities and zeros in every field of receivers, lights and views", made([] {
         Setup s = spot(0.25f);
         const ShadowView view = s.atlas.views[0];
         const LightRecord light = s.lights[0];
         const Receiver receiver = {vec3(0.1f, 0.2f, -2), 0, vec3(0, 0.1f, 1), 0.5f};
         for (const float bad : {kNan, kInf, -kInf, 0.0f}) {
           for (size_t field = 0; field < sizeof(Receiver) / 4; ++field) {
             s.receivers.push_back(receiver);
             if (field != 3) std::memcpy(reinterpret_cast<std::byte*>(&s.receivers.back()) + 4 * field, &bad, 4);
           }
           for (size_t field = 0; field < sizeof(ShadowView) / 4; ++field) {
             s.atlas.views.push_back(view);
             std::memcpy(reinterpret_cast<std::byte*>(&s.atlas.views.back()) + 4 * field, &bad, 4);
             for (const uint32_t kind : {kLightDirectional, kLightSpot}) {
               s.receivers.push_back(receiver);
               s.receivers.back().light =
                   s.add_light(kind, {}, kDown, static_cast<uint32_t>(s.atlas.views.size()) - 1, 1);
             }
           }
           for (size_t axis = 0; axis < 3; ++axis) {
             s.lights.push_back(light);
             s.lights.back().kind = kLightPoint;
             std::memcpy(reinterpret_cast<std::byte*>(&s.lights.back()) + 4 * axis, &bad, 4);
             s.receivers.push_back(receiver);
             s.receivers.back().light = static_cast<uint32_t>(s.lights.size()) - 1;
           }
         }
         return s;
       })},
      {"no_depths", "NaN, infinities, negative and denormal depths in the map", made([] {
         Setup s = spot(0);
         const float depths[] = {kNan, -kNan, kInf, -kInf, -1, 1e-40f, 0, 0.5f, 2};
         for (uint32_t i = 0; i < kSide * kSide; ++i)
           s.atlas.fill({kSide + i % kSide, kSide + i / kSide, 1}, depths[i / 4 % 9]);
         for (uint32_t i = 0; i < 300; ++i) s.receive(0, before_spot(i / 170.0 - 0.9, 0.8 - i / 200.0, 2), {0, 0, 1});
         return s;
       })},
      {"huge_numbers", "positions, normals, rows and biases at the ends of float", made([] {
         Setup s = spot(0.25f);
         for (const float big : {1e10f, 1e20f, 3e38f, -3e38f, 1e-30f, 1e-40f}) {
           s.receivers.push_back({vec3(0.1f, 0.2f, -big), 0, vec3(0, 0, 1), 0});
           s.receivers.push_back({vec3(big, 0.2f, -2), 0, vec3(0, 0, 1), 0});
           s.receivers.push_back({vec3(0.1f, 0.2f, -2), 0, vec3(0, big, big), 0});
           for (uint32_t field = 0; field < 20; ++field) {
             s.atlas.views.push_back(s.atlas.views[0]);
             if (field < 16)
               std::memcpy(reinterpret_cast<std::byte*>(&s.atlas.views.back()) + size_t{4} * field, &big, 4);
             else
               s.atlas.views.back().bias = big;
             s.receive(s.add_light(field % 2 ? kLightSpot : kLightDirectional, {}, kDown,
                                   static_cast<uint32_t>(s.atlas.views.size()) - 1, 1),
                       {0.1, 0.2, -2}, {0, 0.1, 1});
           }
         }
         return s;
       })},
  };
}

std::vector<HardCase> sizes() {
  std::vector<HardCase> cases;
  for (const Extent e : {Extent{1, 1}, {63, 1}, {64, 1}, {65, 1}, {31, 33}, {1921, 1081}})
    cases.push_back({"size_" + std::to_string(e.width) + "x" + std::to_string(e.height),
                     "a size at or beside a boundary", [e] { return typical(e); }});
  cases.push_back({"size_3840x2160", "more groups than a row of them holds",
                   [] {
                     return typical({3840, 2160});
                   },
                   true});
  return cases;
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (auto& more : {plane_cases(), view_cases(), tile_cases(), unseen_cases(), sizes()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<Mutant> mutants() {
  const char* const shared = "harness/glsl/shadows.glsl";
  return {
      {shared, 9701, "the cube's faces up and down change places", "every_face"},
      {shared, 9702, "cascades are not dithered", "cascade_borders"},
      {shared, 9703, "a cascade holds what its filter reaches past", "cascade_borders"},
      {shared, 9704, "the plane leans the other way along y", "on_the_plane"},
      {shared, 9705, "the slope of planes in line with the light is not held", "in_line"},
      {shared, 9706, "behind a light as before it", "behind_the_light"},
      {shared, 9707, "no room for rounding", "on_the_plane"},
      {shared, 9708, "taps in the neighbour's tile", "tile_borders"},
      {shared, 9709, "a texel's corner for its centre", "on_the_plane"},
      {shared, 9710, "the last tap counts in full", "across_a_step"},
      {shared, 9711, "what has no depth casts a shadow", "beyond_the_far_plane"},
      {shared, 9712, "views past the end", "views_past_the_end"},
  };
}

}  // namespace assay::shadow_lookup
