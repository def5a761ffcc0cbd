// Decals of a view: records that are the scene's boxes, items that hold them, culling, receivers, limits.
#include "tests/decals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/oracle.h"

namespace assay::tests {
namespace {

using glm::dmat4;
using glm::dvec3;
using scene::Decal;
using scene::Gathered;
using scene::Scene;

constexpr Extent kExtent = {640, 360};

dvec3 direction(Pcg32& rng) {
  const double z = rng.range(-1, 1), a = rng.range(0, 6.2831853), r = std::sqrt(1 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}
dmat4 some_place(Pcg32& rng, double away) {
  dmat4 m = glm::translate(dmat4(1), direction(rng) * away);
  m = glm::rotate(m, rng.range(0, 6), direction(rng));
  m = glm::scale(m, {rng.below(2) ? -1.0 : 1.0, rng.range(0.3, 3), rng.range(0.3, 3)});
  return glm::rotate(m, rng.range(0, 6), direction(rng));  // sheared
}
Decal some_decal(Pcg32& rng, double away) {
  return {
      .centre = direction(rng) * away,
      .orientation = glm::angleAxis(rng.range(0, 6), direction(rng)),
      .half_extents = {std::pow(10, rng.range(-2, 1)), std::pow(10, rng.range(-2, 1)), std::pow(10, rng.range(-2, 1))}};
}

double by_row(const vec4& r, const dvec3& p) { return dot(dvec3(r), p) + double{r.w}; }
template <class R>
dvec3 by_rows(const R& r, const dvec3& p) {
  return {by_row(r.row_x, p), by_row(r.row_y, p), by_row(r.row_z, p)};
}
// Where a camera-relative position is in the record's box, 0..1.
dvec3 by_record(const Gathered& g, const DecalRecord& d, const dvec3& p) {
  return by_rows(d, d.receiver == kNoReceiver ? p : by_rows(g.receivers.at(d.receiver), p));
}
dvec3 unit_of(const dvec3& in_box) { return {(1 + in_box.x) / 2, (1 - in_box.y) / 2, (1 - in_box.z) / 2}; }

// In front of a camera that looks along -z, with and without a receiver that turns, shears and mirrors.
struct Laid {
  Scene scene = scene::bare();
  scene::Camera camera;
  Gathered gathered;
};
Laid some_scene(Pcg32& rng, bool received) {
  Laid l;
  const double away = std::pow(10, rng.range(0, 3));
  l.camera.eye = direction(rng) * std::pow(10, rng.range(0, 6));
  Decal d = some_decal(rng, 0.2 * away);
  if (received) {
    l.scene.instances[0].to_world = some_place(rng, 0.2 * away);
    l.scene.instances[0].to_world[3] += glm::dvec4(l.camera.eye + dvec3(0, 0, -away), 0);
    d.receiver = 0;
  } else {
    d.centre += l.camera.eye + dvec3(0, 0, -away);
  }
  l.scene.decals = {d};
  l.gathered = gather(l.scene, l.camera, kExtent);
  append_clusters(l.camera, kExtent, {40, 45}, 24, l.gathered);
  return l;
}

TEST(Decals, RecordsAreTheScenesBoxesAndItemsHoldThem) {
  Pcg32 rng(20260310);
  uint32_t seen = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const Laid l = some_scene(rng, trial % 2 == 0);
    const Gathered& g = l.gathered;
    if (g.decals.empty()) continue;
    ++seen;
    const Decal& d = l.scene.decals[0];
    ASSERT_EQ(g.cluster_items.size(), g.lights.size() + 1);
    const ClusterItem& item = g.cluster_items.back();
    const glm::dmat3 axes = {dvec3(item.a), dvec3(item.b), dvec3(item.c)};
    const dmat4 place = d.receiver == scene::kNone ? dmat4(1) : l.scene.instances[0].to_world;
    for (int i = 0; i < 50; ++i) {
      dvec3 at(rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1));
      if (i % 2) at[i / 2 % 3] = i % 4 == 1 ? 1 : -1;  // on a face
      const dvec3 local = d.centre + mat3_cast(d.orientation) * (at * d.half_extents);
      const dvec3 world = dvec3(place * glm::dvec4(local, 1)), p = world - l.camera.eye;
      const InBox box = in_box(l.scene, d, world);
      const dvec3 q = by_record(g, g.decals[0], p);
      for (int k = 0; k < 3; ++k) {
        const double row = length(dvec3(box.by_position[0][k], box.by_position[1][k], box.by_position[2][k]));
        const double reach = length(p) + (g.receivers.empty() ? 0 : length(dvec3(place[3]) - l.camera.eye));
        // Floats of the rows, and doubles of world coordinates a thousand kilometres off.
        const double off = 0x1p-20 * (row * reach + 1) + 1e-9 * row;
        EXPECT_NEAR(q[k], unit_of(at)[k], off) << "decal " << trial << ", point " << i << ", axis " << k;
        EXPECT_NEAR(box.at[k], at[k], 1e-9 * row + 1e-12);
      }
      // Moved by what a position in floats may be off.
      const dvec3 off = p + direction(rng) * (30 * 0x1p-24 * length(p));
      const dvec3 in_item = inverse(axes) * (dvec3(off.x, -off.y, -off.z) - dvec3(item.origin));
      EXPECT_LE(std::max({std::abs(in_item.x), std::abs(in_item.y), std::abs(in_item.z)}), 1) << "decal " << trial;
    }
    for (const vec3& v : {g.decals[0].tangent, g.decals[0].bitangent, g.decals[0].outward})
      EXPECT_NEAR(length(v), 1, 1e-6);
  }
  EXPECT_GT(seen, 400u);
}

// What reaches the view at any point is kept; what is dropped is told.
TEST(Decals, CullingKeepsWhatReachesTheView) {
  Pcg32 rng(5);
  uint32_t dropped = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Scene s = scene::bare();
    Decal d = some_decal(rng, 6);
    d.half_extents = glm::min(d.half_extents, dvec3(3));
    s.decals = {d};
    const scene::Camera camera;
    const Gathered g = gather(s, camera, kExtent);
    const scene::ClipRows rows = clip_rows(camera, kExtent);
    bool reaches = false;
    for (int i = 0; i < 100; ++i) {
      const dvec3 at(rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1));
      const glm::dvec4 p(d.centre + mat3_cast(d.orientation) * (at * d.half_extents), 1);
      const double w = dot(rows.w, p);
      reaches |= w >= camera.near_plane && std::abs(dot(rows.x, p)) <= w && std::abs(dot(rows.y, p)) <= w;
    }
    EXPECT_TRUE(!reaches || g.decals.size() == 1) << trial;
    const bool noted =
        std::ranges::any_of(g.notes, [](const std::string& n) { return n.starts_with("1 of 1 decals"); });
    EXPECT_EQ(noted, g.decals.empty());
    dropped += g.decals.empty();
  }
  EXPECT_GT(dropped, 100u);
  EXPECT_LT(dropped, 900u);
}

// The box stays what it is in the instance's space, and only the way there changes.
TEST(Decals, MoveWithTheirReceivers) {
  Scene s = scene::small();
  const scene::Camera camera = scene::default_camera(s);
  const Gathered before = gather(s, camera, kExtent);
  Decal& d = s.decals[3];
  ASSERT_NE(d.receiver, scene::kNone);
  const dmat4 was = s.instances[d.receiver].to_world;
  s.instances[d.receiver].to_world = glm::rotate(glm::translate(dmat4(1), {0.3, 0.1, -0.2}) * was, 0.3, {0, 1, 0});
  const Gathered after = gather(s, camera, kExtent);
  ASSERT_EQ(before.decals.size(), s.decals.size());
  ASSERT_EQ(after.decals.size(), s.decals.size());
  const uint32_t r = after.decals[3].receiver;
  EXPECT_NE(before.receivers[r].row_x, after.receivers[r].row_x);
  Pcg32 rng(6);
  for (int i = 0; i < 100; ++i) {
    const dvec3 local = d.centre + direction(rng) * 0.3;
    const auto relative = [&](const dmat4& m) { return dvec3(m * glm::dvec4(local, 1)) - camera.eye; };
    const dvec3 q = by_record(before, before.decals[3], relative(was)),
                moved = by_record(after, after.decals[3], relative(s.instances[d.receiver].to_world));
    EXPECT_NEAR(length(q - moved), 0, 1e-4);
  }
  EXPECT_EQ(before.decals[0].row_x, after.decals[0].row_x) << "the others stay";
}

TEST(Decals, OnesThatShowTheSameShareARectangle) {
  Scene s = scene::small();
  s.decals.assign(3, s.decals[0]);
  s.decals[2].roughness = 0.9f;
  const Gathered g = gather(s, scene::default_camera(s), kExtent);
  ASSERT_EQ(g.decals.size(), 3u);
  const auto place = [&](size_t i) { return std::pair(g.decals[i].scale_bias, g.decals[i].page); };
  EXPECT_EQ(place(0), place(1));
  EXPECT_NE(place(0), place(2));
  EXPECT_EQ(g.decal_atlas.size(), kAtlasTextures);
  EXPECT_EQ(g.decal_counts.decals, 3u);
}

TEST(Decals, MoreThanCellsKnowAreLeftOutAndTold) {
  Scene s = scene::small();
  s.decals.assign(kMaxClusterDecals + 7, s.decals[0]);
  const Gathered g = gather(s, scene::default_camera(s), kExtent);
  EXPECT_EQ(g.decals.size(), kMaxClusterDecals);
  EXPECT_TRUE(std::ranges::any_of(
      g.notes, [](const std::string& n) { return n.find("first 4096 of 4103 decals") != std::string::npos; }));
}

TEST(Decals, FaultsAreNamed) {
  const Scene s = scene::small();
  const auto fault = [&](const auto& spoil) {
    Decal d = s.decals[0];
    spoil(d);
    return fault_of(d, s);
  };
  EXPECT_EQ(fault([](Decal&) {}), "");
  EXPECT_NE(fault([](Decal& d) { d.centre.x = NAN; }), "");
  EXPECT_NE(fault([](Decal& d) { d.half_extents.y = 0; }), "");
  EXPECT_NE(fault([](Decal& d) { d.half_extents.y = NAN; }), "");
  EXPECT_NE(fault([](Decal& d) { d.orientation = {0, 0, 0, 0}; }), "");
  EXPECT_NE(fault([](Decal& d) { d.weights.z = -1; }), "");
  EXPECT_NE(fault([](Decal& d) { d.colour.w = 2; }), "");
  EXPECT_NE(fault([](Decal& d) { d.roughness = NAN; }), "");
  EXPECT_NE(fault([](Decal& d) { d.fade_distance = -1; }), "");
  EXPECT_NE(fault([](Decal& d) { d.normal_mode = 3; }), "");
  EXPECT_NE(fault([](Decal& d) { d.receiver = 1000; }), "");
  EXPECT_NE(fault([](Decal& d) { d.colour_image = 1000; }), "");
  EXPECT_NE(fault([&](Decal& d) { d.normal_image = s.materials[0].base_image; }), "") << "pictures of unequal size";
  Scene spoilt = s;
  spoilt.decals[1].receiver = 1000;
  EXPECT_THROW(gather(spoilt, scene::default_camera(s), kExtent), std::runtime_error);
}

}  // namespace
}  // namespace assay::tests
