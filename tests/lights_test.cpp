// Lights of a view: glTF's semantics, camera-relative records, culling, the default.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/glb.h"

namespace assay::tests {
namespace {

using scene::Gathered;
using scene::Light;
using scene::LightKind;
using scene::Scene;

constexpr Extent kExtent = {640, 360};

Scene lit(std::vector<Light> lights) {
  Scene s = scene::bare();
  s.lights = std::move(lights);
  return s;
}
Gathered seen(const Scene& s) { return gather(s, default_camera(s), kExtent); }

double cone(const LightRecord& l, double angle) {
  const double c = std::clamp(std::cos(angle) * l.cone_scale + l.cone_offset, 0.0, 1.0);
  return c * c;
}

TEST(Lights, ConesFallFromInnerToOuterAngle) {
  const bool passed = rc::check("cones", [] {
    const float outer = static_cast<float>(*rc::gen::inRange(100, 1570)) * 0.001f;
    const float inner = outer * static_cast<float>(*rc::gen::inRange(0, 90)) * 0.01f;
    const Gathered g = seen(lit({{.kind = LightKind::spot, .inner_rad = inner, .outer_rad = outer}}));
    RC_ASSERT(g.lights.size() == 1u);
    const LightRecord& l = g.lights[0];
    const double span = std::cos(double{inner}) - std::cos(double{outer});
    RC_PRE(span > 0.001);
    // Two roundings of the record's floats, of the size of scale: 2^-24 each of cos * scale and of offset.
    const double off = 2 * std::ldexp(1.0, -24) * 2 / span;
    RC_ASSERT(cone(l, inner) >= 1 - 2 * off);
    RC_ASSERT(cone(l, outer) <= off * off);
    RC_ASSERT(cone(l, std::min(outer + 0.01, 1.57)) <= off * off);
    const double halfway = std::acos((std::cos(double{inner}) + std::cos(double{outer})) / 2);
    RC_ASSERT(std::abs(cone(l, halfway) - 0.25) <= 2 * off);
  });
  EXPECT_TRUE(passed);
}

TEST(Lights, EqualAnglesMakeANarrowEdgeInsteadOfADivisionByZero) {
  const Gathered g = seen(lit({{.kind = LightKind::spot, .inner_rad = 0.5f, .outer_rad = 0.5f}}));
  EXPECT_FLOAT_EQ(g.lights[0].cone_scale, 1000);
  EXPECT_NEAR(cone(g.lights[0], 0.49), 1, 1e-6);
  EXPECT_NEAR(cone(g.lights[0], 0.51), 0, 1e-6);
}

TEST(Lights, RecordsAreRelativeToTheCameraAndWhole) {
  Scene s = lit({{.kind = LightKind::point,
                  .position = {1e6 + 0.125, 2, -1e6},
                  .direction = {0, 0, 1},
                  .colour = {1, 0.5f, 0.25f},
                  .intensity = 8,
                  .range = 3},
                 {.kind = LightKind::directional, .direction = {0, -1, 0}, .intensity = 2}});
  s.instances[0].to_world[3] = glm::dvec4(1e6, 0, -1e6, 1);
  const Gathered g = gather(s, scene::look_at({1e6, 0, -1e6 + 3}, {1e6, 0, -1e6}, 0.8), kExtent);
  ASSERT_EQ(g.lights.size(), 2u);
  EXPECT_EQ(g.counts.lights, 2u);
  EXPECT_EQ(g.lights[0].position, vec3(0.125f, 2, -3));
  EXPECT_EQ(g.lights[0].colour, vec3(8, 4, 2));
  EXPECT_EQ(g.lights[0].range, 3.0f);
  EXPECT_EQ(g.lights[0].kind, kLightPoint);
  EXPECT_EQ(cone(g.lights[0], 1.0), 1.0);
  EXPECT_EQ(g.lights[1].kind, kLightDirectional);
  EXPECT_EQ(g.lights[1].direction, vec3(0, -1, 0));
  EXPECT_EQ(g.lights[1].colour, vec3(2, 2, 2));
}

// A light that lights any point in view is kept; one is dropped only with a note.
TEST(Lights, CullingKeepsEveryLightThatReachesTheView) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-3000, 3000), [](int i) { return i * 0.01; });
  uint32_t dropped = 0;
  const bool passed = rc::check("culling", [&] {
    Light light = {.kind = LightKind::point, .position = {*coordinate, *coordinate, *coordinate}};
    light.range = static_cast<float>(*rc::gen::inRange(1, 1000)) * 0.01f;
    const Scene s = lit({light});
    const scene::Camera camera =
        scene::look_at({*coordinate, *coordinate, *coordinate}, {*coordinate + 0.005, *coordinate, *coordinate}, 0.8);
    const Gathered g = gather(s, camera, kExtent);
    const auto unit = [&] { return *rc::gen::inRange(-1000, 1001) * 0.001; };
    const scene::ClipRows rows = clip_rows(camera, kExtent);
    bool reaches = false;
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 towards(unit(), unit(), unit());
      const double far = length(towards);
      const glm::dvec4 p(light.position + towards * (far > 1 ? 1 / far : 1.0) * double{light.range} - camera.eye, 1);
      const double w = dot(rows.w, p);
      reaches |= w >= camera.near_plane && std::abs(dot(rows.x, p)) <= w && std::abs(dot(rows.y, p)) <= w;
    }
    RC_ASSERT(!reaches || g.lights.size() == 1u);
    const bool noted = std::any_of(g.notes.begin(), g.notes.end(), [](const std::string& note) {
      return note.find("1 of 1 lights") != std::string::npos;
    });
    RC_ASSERT(noted == g.lights.empty());
    dropped += g.lights.empty();
  });
  EXPECT_TRUE(passed);
  EXPECT_GT(dropped, 10u);
}

TEST(Lights, UnlimitedAndDirectionalLightsReachEverywhere) {
  const Gathered g = seen(lit({{.kind = LightKind::point, .position = {0, 0, 1e5}},
                               {.kind = LightKind::spot, .position = {0, 0, 1e5}},
                               {.kind = LightKind::directional, .position = {0, 0, 1e5}, .range = 1},
                               {.kind = LightKind::point, .position = {0, 0, 1e5}, .range = 1}}));
  EXPECT_EQ(g.lights.size(), 3u);
}

TEST(Lights, ASceneWithoutAnyGetsOneAndANote) {
  const Scene s = scene::bare();
  const scene::Camera camera = default_camera(s);
  const Gathered g = gather(s, camera, kExtent);
  ASSERT_EQ(g.lights.size(), 1u);
  EXPECT_EQ(g.counts.lights, 1u);
  EXPECT_EQ(g.lights[0].kind, kLightDirectional);
  EXPECT_NEAR(length(g.lights[0].direction), 1, 1e-6);
  // It shines the way the camera looks, downwards and from the right.
  const glm::dvec3 seen_by_camera = inverse(camera.orientation) * glm::dvec3(g.lights[0].direction);
  EXPECT_LT(seen_by_camera.z, -0.7);
  EXPECT_LT(seen_by_camera.y, 0);
  EXPECT_LT(seen_by_camera.x, 0);
  ASSERT_EQ(g.notes.size(), 1u);
  EXPECT_NE(g.notes[0].find("no light"), std::string::npos);
}

TEST(Lights, GltfDefaultsAreTheExtensions) {
  Glb g = quad();
  Json& lights = g.doc["extensions"]["KHR_lights_punctual"]["lights"];
  lights = {{{"type", "spot"}, {"spot", Json::object()}}};
  const Scene spot = load(g);
  EXPECT_EQ(spot.lights[0].colour, glm::vec3(1));
  EXPECT_EQ(spot.lights[0].intensity, 1);
  EXPECT_EQ(spot.lights[0].range, 0);
  EXPECT_EQ(spot.lights[0].inner_rad, 0);
  EXPECT_FLOAT_EQ(spot.lights[0].outer_rad, 0.78539816f);
  // Neither scale nor a mirroring node changes range, intensity or the unit length of the direction.
  g.doc["nodes"][0]["scale"] = {3, 3, -3};
  g.doc["nodes"][2].erase("rotation");
  lights = {{{"type", "directional"}, {"intensity", 5}}};
  const Scene scaled = load(g);
  EXPECT_NEAR(length(scaled.lights[0].direction - glm::vec3(0, 0, 1)), 0, 1e-6);
  EXPECT_EQ(scaled.lights[0].intensity, 5);
}

}  // namespace
}  // namespace assay::tests
