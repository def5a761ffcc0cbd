// Built-in scenes, cameras, feature bits, and the tests' own ray caster.
#include "harness/scene/scene.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <set>

#include "tests/raycaster.h"

namespace assay::tests {
namespace {

using scene::Camera;
using scene::Scene;

// Where a world point lands, in pixels, and its distance along the view axis, from the camera's axes alone.
glm::dvec3 project(const Camera& camera, Extent extent, const glm::dvec3& world) {
  const glm::dvec3 view = inverse(camera.orientation) * (world - camera.eye);
  const double focal = 1 / std::tan(camera.vertical_fov_rad / 2),
               aspect = static_cast<double>(extent.width) / extent.height;
  const double x = focal / aspect * view.x / -view.z, y = focal * view.y / -view.z;
  return {(x * 0.5 + 0.5) * extent.width, (0.5 - y * 0.5) * extent.height, -view.z};
}

TEST(Scene, BareIsOneTriangleOfOneMaterial) {
  const Scene s = scene::bare();
  EXPECT_EQ(s.meshes.size(), 1u);
  EXPECT_EQ(s.meshes[0].indices.size(), 3u);
  EXPECT_EQ(s.materials.size(), 1u);
  EXPECT_TRUE(s.images.empty());
  EXPECT_TRUE(s.lights.empty());
  EXPECT_EQ(default_camera(s).name, "front");
}

TEST(Scene, SmallHoldsWhatTheKernelsHaveToTellApart) {
  const Scene s = scene::small();
  std::set<uint32_t> bits;
  for (const scene::Material& m : s.materials) bits.insert(feature_bits(s, m));
  EXPECT_GE(bits.size(), 8u);
  std::set<scene::LightKind> lights;
  for (const scene::Light& l : s.lights) lights.insert(l.kind);
  EXPECT_EQ(lights.size(), 3u);
  std::vector<uint32_t> uses(s.meshes.size());
  uint32_t mirrored = 0;
  for (const scene::Instance& i : s.instances) ++uses[i.mesh], mirrored += determinant(i.to_world) < 0;
  EXPECT_GE(*std::max_element(uses.begin(), uses.end()), 8u);
  EXPECT_GE(mirrored, 1u);
  uint64_t triangles = 0;
  for (const scene::Instance& i : s.instances) triangles += s.meshes[i.mesh].indices.size() / 3;
  EXPECT_GT(triangles, 20000u);
}

TEST(Scene, SmallIsTheSameEveryTime) {
  const Scene a = scene::small(), b = scene::small();
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (size_t m = 0; m < a.meshes.size(); ++m) {
    EXPECT_EQ(a.meshes[m].positions, b.meshes[m].positions);
    EXPECT_EQ(a.meshes[m].indices, b.meshes[m].indices);
  }
  for (size_t i = 0; i < a.images.size(); ++i) EXPECT_EQ(a.images[i].rgba, b.images[i].rgba);
}

// Indices in range, parts that tile them, unit normals and tangents at right angles, normals on the front's side.
void expect_sound_meshes(const Scene& s) {
  for (const scene::Mesh& m : s.meshes) {
    SCOPED_TRACE(m.name);
    ASSERT_EQ(m.positions.size(), m.attributes.size());
    uint32_t next = 0;
    for (const scene::Part& p : m.parts) {
      EXPECT_EQ(p.first_index, next);
      EXPECT_LT(p.material, s.materials.size());
      next += p.index_count;
    }
    EXPECT_EQ(next, m.indices.size());
    for (const VertexAttributes& a : m.attributes) {
      const glm::vec3 t(a.tangent.x, a.tangent.y, a.tangent.z);
      EXPECT_NEAR(length(a.normal), 1, 1e-5);
      EXPECT_NEAR(length(t), 1, 1e-5);
      EXPECT_NEAR(dot(a.normal, t), 0, 0.05);
    }
    for (size_t i = 0; i < m.indices.size(); i += 3) {
      ASSERT_LT(std::max({m.indices[i], m.indices[i + 1], m.indices[i + 2]}), m.positions.size());
      const glm::vec3 a = m.positions[m.indices[i]], b = m.positions[m.indices[i + 1]],
                      c = m.positions[m.indices[i + 2]];
      EXPECT_GE(dot(cross(b - a, c - a), m.attributes[m.indices[i]].normal), 0);
    }
  }
}

TEST(Scene, BuiltInMeshesAreSound) {
  expect_sound_meshes(scene::small());
  expect_sound_meshes(scene::default_scene());
}

TEST(Scene, LookAtPutsItsTargetInTheMiddleAndUpUp) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int i) { return i * 0.01; });
  const bool passed = rc::check("look_at", [&] {
    const glm::dvec3 eye(*coordinate, *coordinate, *coordinate), target(*coordinate, *coordinate, *coordinate);
    RC_PRE(length(eye - target) > 0.5);
    const Camera camera = scene::look_at(eye, target, 0.8);
    const glm::dvec3 middle = project(camera, {640, 480}, target);
    RC_ASSERT(std::abs(middle.x - 320) < 1e-6 && std::abs(middle.y - 240) < 1e-6);
    RC_ASSERT(std::abs(middle.z - length(target - eye)) < 1e-6);
    const glm::dvec3 above = project(camera, {640, 480}, target + camera.orientation * glm::dvec3(0, 0.1, 0));
    RC_ASSERT(above.y < 240 && (camera.orientation * glm::dvec3(0, 1, 0)).y >= -1e-9);
  });
  EXPECT_TRUE(passed);
}

TEST(Scene, ClipRowsProjectAsTheCameraDoes) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-100000, 100000), [](int i) { return i * 0.001; });
  const bool passed = rc::check("clip rows", [&] {
    const Extent extent = {*rc::gen::inRange(1u, 4000u), *rc::gen::inRange(1u, 4000u)};
    const glm::dvec3 eye(*coordinate, *coordinate, *coordinate), target(*coordinate, *coordinate, *coordinate);
    const glm::dvec3 point(*coordinate, *coordinate, *coordinate);
    RC_PRE(length(eye - target) > 0.5);
    const Camera camera = scene::look_at(eye, target, 0.8);
    const scene::ClipRows rows = clip_rows(camera, extent);
    const glm::dvec4 relative(point - eye, 1);
    const double w = dot(rows.w, relative);
    const glm::dvec3 pixel = project(camera, extent, point);
    RC_PRE(pixel.z > 0.1);
    RC_ASSERT(std::abs(w - pixel.z) < 1e-9);
    RC_ASSERT(std::abs((dot(rows.x, relative) / w * 0.5 + 0.5) * extent.width - pixel.x) <
              1e-6 * (1 + std::abs(pixel.x)));
    RC_ASSERT(std::abs((dot(rows.y, relative) / w * 0.5 + 0.5) * extent.height - pixel.y) <
              1e-6 * (1 + std::abs(pixel.y)));
  });
  EXPECT_TRUE(passed);
}

// A box of the given half extents around a centre, with its faces turned outwards or inwards.
Scene box_scene(const glm::dvec3& half, const glm::dvec3& centre, bool inwards) {
  Scene s;
  s.materials.push_back({.name = "box"});
  scene::Mesh m;
  for (int i = 0; i < 8; ++i)
    m.positions.emplace_back(half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  m.attributes.resize(8, {{0, 1, 0}, {1, 0, 0, 1}, {0, 0}});
  const uint32_t faces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  for (const auto& f : faces)
    for (const int k : {0, 1, 2, 0, 2, 3}) m.indices.push_back(f[k]);
  if (inwards) std::reverse(m.indices.begin(), m.indices.end());
  m.parts = {{0, 36, 0}};
  s.meshes.push_back(m);
  s.instances.push_back({0, glm::dmat4(1)});
  s.instances[0].to_world[3] = glm::dvec4(centre, 1);
  return s;
}

TEST(Scene, OutsideViewsHoldTheWholeBox) {
  const auto size = rc::gen::map(rc::gen::inRange(1, 100000), [](int i) { return i * 0.01; });
  const bool passed = rc::check("everything in view", [&] {
    const glm::dvec3 half(*size, *size, *size), centre(*size, *size, *size);
    const Scene s = box_scene(half, centre, false);
    const Camera camera = default_camera(s);
    RC_ASSERT(camera.name == "outside");
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 corner = centre + half * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      const glm::dvec3 p = project(camera, {640, 480}, corner);
      RC_ASSERT(p.x >= 0 && p.x <= 640 && p.y >= 0 && p.y <= 480 && p.z > camera.near_plane);
    }
  });
  EXPECT_TRUE(passed);
}

TEST(Scene, RoomsAreSeenFromInsideAlongTheirLength) {
  const Camera camera = default_camera(box_scene({20, 5, 8}, {3, 5, 0}, true));
  EXPECT_EQ(camera.name, "inside");
  EXPECT_NEAR(camera.eye.x, 3 - 0.8 * 20, 1e-9);
  EXPECT_NEAR(camera.eye.y, 1.7, 1e-9);
  EXPECT_NEAR((camera.orientation * glm::dvec3(0, 0, -1)).x, 1, 1e-9);
  EXPECT_EQ(default_camera(box_scene({20, 5, 8}, {3, 5, 0}, false)).name, "outside");
}

TEST(Scene, FeatureBitsFollowTheMaterial) {
  Scene s;
  scene::Material m = {.name = "Sponza_Curtain_Red", .metallic = 0};
  EXPECT_EQ(feature_bits(s, m), kFeatureOpaque | kFeatureCloth);
  m = {.name = "mirror", .metallic = 1, .roughness = 0.1f, .emissive = {0, 0, 1}};
  EXPECT_EQ(feature_bits(s, m), kFeatureOpaque | kFeatureReflective | kFeatureEmissive);
  // Mean roughness 0.8 of the image: no mirror, whatever the factor of 1 says.
  s.images.push_back({"mr", 1, 1, {0, 204, 255, 255}});
  m = {.name = "rusty", .metallic_roughness_image = 0};
  EXPECT_EQ(feature_bits(s, m), kFeatureOpaque | kFeatureTextured);
  m.roughness = 0.25f;
  EXPECT_EQ(feature_bits(s, m), kFeatureOpaque | kFeatureTextured | kFeatureReflective);
}

TEST(Scene, ShaderClassesFollowTheFeatures) {
  const Scene s;
  using scene::AlphaMode;
  const std::pair<scene::Material, uint32_t> expected[] = {
      {{.name = "stone"}, kShaderOpaque},
      {{.name = "chain", .alpha = AlphaMode::masked}, kShaderMasked},
      {{.name = "sheet", .double_sided = true}, kShaderOpaque},
      {{.name = "leaf", .alpha = AlphaMode::masked}, kShaderFoliage},
      {{.name = "leaf"}, kShaderOpaque},  // not masked: a carved one
      {{.name = "curtain", .alpha = AlphaMode::masked}, kShaderCloth},
      {{.name = "skin"}, kShaderSkin},
      {{.name = "lamp", .emissive = {0, 0, 1}}, kShaderEmissiveDetail},
      {{.name = "lamp", .emissive = {0, 0, 1}, .alpha = AlphaMode::masked}, kShaderMasked},
      {{.name = "street", .features = kFeaturePuddles}, kShaderWet},
      {{.name = "stone", .shader = kShaderTwoLayer}, kShaderTwoLayer},
  };
  for (const auto& [material, shader] : expected) EXPECT_EQ(shader_class(s, material), shader) << material.name;
}

// ---- The ray caster ------------------------------------------------------------------------------------------------

TEST(Scene, RayCasterFindsTheTriangleThatItAimsAt) {
  const Scene s = box_scene({1, 2, 3}, {0, 0, 0}, false);
  const Camera camera = scene::look_at({4, 5, 6}, {0, 0, 0}, 0.8);
  const Extent extent = {320, 200};
  for (uint32_t t = 0; t < 12; ++t) {
    glm::dvec3 centre(0);
    for (uint32_t k = 0; k < 3; ++k) centre += glm::dvec3(s.meshes[0].positions[s.meshes[0].indices[t * 3 + k]]) / 3.0;
    const glm::dvec3 p = project(camera, extent, centre);
    const std::optional<Hit> hit = cast(s, camera, extent, p.x, p.y);
    ASSERT_TRUE(hit.has_value());
    // Three faces look at the eye: +x, +y, +z, triangles 0, 1, 4, 5, 8, 9.
    const bool seen = t % 4 < 2;
    EXPECT_EQ(hit->triangle == t, seen) << t;
    if (seen)
      EXPECT_NEAR(hit->distance, p.z, 1e-9);
    else
      EXPECT_LT(hit->distance, p.z);
    // Back faces are no surface; a point on an edge belongs to both triangles.
    EXPECT_TRUE(hit->second > 1e30 || hit->edge_px < 1e-9) << t;
  }
}

TEST(Scene, RayCasterTellsHowFarTheEdgeIs) {
  const Scene s = box_scene({1, 1, 1}, {0, 0, 0}, false);
  const Camera camera = scene::look_at({0, 0, 11}, {0, 0, 0}, 0.8);
  const Extent extent = {400, 400};
  const double right = project(camera, extent, {1, 0, 1}).x;
  for (const double away : {0.01, 0.3, 0.9}) {
    const std::optional<Hit> in = cast(s, camera, extent, right - away, 190.3),
                             out = cast(s, camera, extent, right + away, 190.3);
    ASSERT_TRUE(in && out);
    EXPECT_NEAR(in->edge_px, away, 1e-6);
    EXPECT_EQ(in->instance, 0u);
    EXPECT_NEAR(out->edge_px, away, 1e-6);
    EXPECT_EQ(out->instance, scene::kNone);
  }
  EXPECT_FALSE(cast(s, camera, extent, right + 1.5, 190.3).has_value());
}

// Where everything is depends on the frame's number alone; what a decal lies on takes it along.
TEST(Scene, MovesByTheFramesNumber) {
  const Scene s = scene::small();
  Scene moved = s;
  scene::move_to_frame(20, s, moved);
  for (size_t i = 0; i < s.instances.size(); ++i) {
    const scene::Motion& m = s.instances[i].motion;
    const bool moves = m.turn_rad != 0 || m.reach != glm::dvec3(0);
    EXPECT_EQ(moved.instances[i].to_world != s.instances[i].to_world, moves) << i;
  }
  EXPECT_NE(moved.lights[1].position, s.lights[1].position);
  EXPECT_NE(moved.lights[2].direction, s.lights[2].direction);
  EXPECT_EQ(moved.lights[0].direction, s.lights[0].direction);
  const Camera still = scene::default_camera(s);
  const auto at_first = scene::gather(s, still, {64, 36}).receivers,
             later = scene::gather(moved, still, {64, 36}).receivers;
  ASSERT_FALSE(at_first.empty());
  ASSERT_EQ(at_first.size(), later.size());
  EXPECT_NE(std::memcmp(at_first.data(), later.data(), at_first.size() * sizeof(at_first[0])), 0);

  scene::move_to_frame(0, s, moved);
  for (size_t i = 0; i < s.instances.size(); ++i) EXPECT_EQ(moved.instances[i].to_world, s.instances[i].to_world);
  for (size_t i = 0; i < s.lights.size(); ++i) {
    EXPECT_EQ(moved.lights[i].position, s.lights[i].position);
    EXPECT_EQ(moved.lights[i].direction, s.lights[i].direction);
  }
  EXPECT_EQ(scene::camera_in_frame(still, 0).orientation, still.orientation);
  const Camera walked = scene::camera_in_frame(still, 20);
  EXPECT_GT(length(walked.eye - still.eye), 0.3);  // 1.4 m a second at first
  EXPECT_LT(length(walked.eye - still.eye), 0.5);
}

TEST(Scene, RayCasterCutsMaskedTriangles) {
  Scene s = box_scene({1, 1, 1}, {0, 0, 0}, false);
  const Camera camera = scene::look_at({0, 0, 11}, {0, 0, 0}, 0.8);
  s.materials[0].alpha = scene::AlphaMode::masked;
  for (const uint8_t alpha : {uint8_t{0}, uint8_t{255}}) {
    s.images = {{"flat", 2, 2, std::vector<uint8_t>(16, alpha)}};
    s.materials[0].base_image = 0;
    const std::optional<Hit> hit = cast(s, camera, {400, 400}, 203, 190);
    EXPECT_EQ(hit && hit->instance == 0, alpha == 255);
    EXPECT_TRUE(!hit || !hit->alpha_close);
  }
  s.images[0].rgba[3] = 0;
  EXPECT_TRUE(cast(s, camera, {400, 400}, 203, 190)->alpha_close);
}

}  // namespace
}  // namespace assay::tests
