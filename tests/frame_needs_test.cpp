// Only what a scene needs: what it lacks has no pass, no pipeline and no bytes.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/frame/frame.h"
#include "harness/frame/graph.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

scene::Scene without_particles(scene::Scene s) {
  s.particles.clear();
  return s;
}

TEST(FrameNeeds, RemovingParticlesRemovesTheirPassesAndBytes) {
  const scene::Scene with = scene::small(), without = without_particles(with);
  scene::Scene elsewhere = with;
  for (scene::Particle& p : elsewhere.particles) p.centre += glm::dvec3(0, 0, 1e4);
  const auto info = device::info(*device());
  const frame::Options options = {.size = {320, 200}};
  const auto explained = [&](const scene::Scene& s) {
    return frame::explain(info, s, scene::default_camera(with), options);
  };
  const auto runs = [](const frame::Explanation& e) {
    return std::ranges::any_of(e.passes,
                               [](const frame::PassNote& p) { return p.runs && p.kernel.starts_with("particle"); });
  };
  const auto bytes = [](const frame::Explanation& e) {
    uint64_t sum = 0;
    for (const frame::ResourceNote& r : e.resources)
      if (r.name.find("particle") != std::string::npos) sum += r.bytes;
    return sum;
  };
  const auto full = explained(with), bare = explained(without);
  EXPECT_TRUE(runs(full));
  EXPECT_FALSE(runs(bare));
  EXPECT_GT(bytes(full), 0u);
  EXPECT_EQ(bytes(bare), 0u);
  EXPECT_LT(frame::total_bytes(bare), frame::total_bytes(full));
  // Records out of view are read by nothing.
  EXPECT_FALSE(runs(explained(elsewhere)));
  EXPECT_EQ(frame::total_bytes(explained(elsewhere)), frame::total_bytes(bare));
}

// Lights that reach nothing take their cells and lists with them.
TEST(FrameNeeds, RemovingLightsRemovesTheirPassesAndBytes) {
  scene::Scene with = without_particles(scene::small()), dark = with;
  with.decals.clear(), dark.decals.clear();
  for (scene::Light& l : dark.lights)
    l = {.kind = scene::LightKind::point, .position = {0, 1e5, 0}, .range = 1, .motion = {}};
  const auto info = device::info(*device());
  const frame::Options options = {.size = {320, 200}};
  const auto full = frame::explain(info, with, scene::default_camera(with), options),
             bare = frame::explain(info, dark, scene::default_camera(with), options);
  const auto clusters = [](const frame::Explanation& e) {
    return std::ranges::any_of(e.passes,
                               [](const frame::PassNote& p) { return p.runs && p.kernel.starts_with("cluster"); });
  };
  EXPECT_TRUE(clusters(full));
  EXPECT_FALSE(clusters(bare));
  EXPECT_LT(frame::total_bytes(bare), frame::total_bytes(full));
}

// A class of materials that nothing shows has no dispatch, and its textures are not there.
TEST(FrameNeeds, RemovingMaterialsRemovesTheirPassesAndBytes) {
  const scene::Scene with = scene::small();
  scene::Scene without = with;
  const auto cloth = [&](const scene::Part& p) { return (with.materials[p.material].features & kFeatureCloth) != 0; };
  for (scene::Mesh& m : without.meshes) std::erase_if(m.parts, cloth);
  const auto info = device::info(*device());
  const frame::Options options = {.size = {320, 200}};
  const auto full = frame::explain(info, with, scene::default_camera(with), options),
             bare = frame::explain(info, without, scene::default_camera(with), options);
  const auto weaves = [](const frame::Explanation& e) {
    return std::ranges::any_of(
        e.passes, [](const frame::PassNote& p) { return p.runs && p.pass.find("cloth") != std::string::npos; });
  };
  EXPECT_TRUE(weaves(full));
  EXPECT_FALSE(weaves(bare));
  EXPECT_LT(frame::total_bytes(bare), frame::total_bytes(full));
}

// Pipelines that a frame of `small` makes.
size_t pipelines(const scene::Scene& s, const frame::Options& o = {}) {
  device::Handle own = device::open(device_options());
  frame::Options options = o;
  options.size = {160, 90}, options.warm_up = false;
  frame::render(*own, s, scene::default_camera(scene::small()), options);
  return device::pipeline_count(*own);
}

TEST(FrameNeeds, WhatIsRemovedHasNoPipelines) {
  const scene::Scene with = scene::small();
  const size_t full = pipelines(with);
  const auto less = [&](const char* what, const auto& remove) {
    scene::Scene s = with;
    remove(s);
    EXPECT_LT(pipelines(s), full) << what;
  };
  less("particles", [](scene::Scene& s) { s.particles.clear(); });
  less("decals", [](scene::Scene& s) { s.decals.clear(); });
  less("lights", [](scene::Scene& s) { s.lights.clear(); });
  less("shadows", [](scene::Scene& s) {
    for (scene::Light& l : s.lights) l.casts_shadows = false;
  });
  less("a class of materials", [](scene::Scene& s) {
    for (scene::Mesh& m : s.meshes)
      std::erase_if(m.parts,
                    [&](const scene::Part& p) { return (s.materials[p.material].features & kFeatureCloth) != 0; });
  });
  EXPECT_GT(pipelines(with, {.vrcs = "on"}), full) << "variable rates";
}

}  // namespace
}  // namespace assay::tests
