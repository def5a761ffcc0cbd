// Particles of scenes: emitters, records and their order, motion; and what a frame does with them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "harness/frame/frame.h"
#include "harness/half.h"
#include "tests/drawn.h"

namespace assay::tests {
namespace {

using scene::Emitter;
using scene::EmitterKind;

scene::Scene without_particles(scene::Scene s) {
  s.particles.clear();
  return s;
}

TEST(Particles, RecordsFaceTheViewerAndKeepTheirNumbers) {
  const scene::Scene s = scene::small();
  const auto g = scene::gather(s, scene::default_camera(s), {320, 200});
  ASSERT_EQ(g.particles.size(), s.particles.size());
  ASSERT_FALSE(g.particles.empty());
  for (size_t i = 0; i < g.particles.size(); ++i) {
    const ParticleRecord& p = g.particles[i];
    const glm::dvec3 centre(p.centre), right(p.right), up(p.up);
    EXPECT_LT(length(centre - (s.particles[i].centre - scene::default_camera(s).eye)), 1e-5) << i;
    EXPECT_LT(std::abs(dot(normalize(centre), normalize(right))), 1e-5) << i;
    EXPECT_LT(std::abs(dot(normalize(centre), normalize(up))), 1e-5) << i;
    EXPECT_GE(length(right), length(up) * (1 - 1e-6)) << "the first axis is along the velocity";
  }
}

TEST(Particles, AreDrawnFarthestFirstAndOnlyInView) {
  scene::Scene s = scene::bare();
  const scene::Camera camera = scene::default_camera(s);  // at z = 3, looking along -z
  const auto at = [](double x, double z) { return scene::Particle{.centre = {x, 0.8, z}, .radius = 0.1f}; };
  s.particles = {at(0, 2), at(0, 0), at(0, 5), at(100, 0), at(0.2, 0), at(0, 1)};
  s.particles.push_back(at(0, 1.5));
  s.particles.back().quality = 0;
  const auto g = scene::gather(s, camera, {64, 64});
  // Behind, far aside and of no quality are left out; of equal depths the first comes first.
  EXPECT_EQ(g.particle_order, (std::vector<uint32_t>{1, 4, 5, 0}));
  EXPECT_EQ(g.particles.size(), 7u);
}

TEST(Particles, VelocityDrawsThemOut) {
  scene::Scene s = scene::bare();
  s.particles = {{.centre = {0, 0.8, 0}, .velocity = {0, 4, 0}, .radius = 0.1f}};
  const auto g = scene::gather(s, scene::default_camera(s), {64, 64});
  EXPECT_GT(length(glm::dvec3(g.particles[0].right)), 0.15);
  EXPECT_NEAR(length(glm::dvec3(g.particles[0].up)), 0.1, 1e-6);
}

TEST(Particles, DriftAndBeginAgain) {
  const scene::Scene from = scene::small();
  scene::Scene a = from, b = from;
  scene::move_to_frame(40, from, a);
  scene::move_to_frame(7, from, b);
  scene::move_to_frame(40, from, b);
  size_t moved = 0;
  for (size_t i = 0; i < from.particles.size(); ++i) {
    EXPECT_EQ(a.particles[i].centre, b.particles[i].centre) << "a function of the frame alone";
    EXPECT_LT(a.particles[i].age_s, from.particles[i].life_s);
    moved += a.particles[i].centre != from.particles[i].centre;
    // Wherever it is, it is on its way.
    const glm::dvec3 off = a.particles[i].centre - from.particles[i].centre;
    EXPECT_LT(length(off - from.particles[i].velocity * (a.particles[i].age_s - from.particles[i].age_s)), 1e-9);
  }
  EXPECT_EQ(moved, from.particles.size());
  scene::move_to_frame(0, from, a);
  EXPECT_EQ(a.particles[0].centre, from.particles[0].centre);
}

TEST(Particles, FaultsOfEmittersAreNamed) {
  EXPECT_EQ(fault_of(Emitter{}), "");
  EXPECT_NE(fault_of(Emitter{.half_extents = {-1, 0, 0}}), "");
  EXPECT_NE(fault_of(Emitter{.count = 1u << 21}), "");
  EXPECT_NE(fault_of(Emitter{.radius = 0}), "");
  EXPECT_NE(fault_of(Emitter{.opacity = 1.5f}), "");
  EXPECT_NE(fault_of(Emitter{.colour = {0, 2, 0}}), "");
  EXPECT_NE(fault_of(Emitter{.height = -1}), "");
}

// ---- In the frame

TEST(Particles, AreSeenInThePicture) {
  const scene::Scene with = scene::small();
  const frame::Options o = {.size = {320, 200}, .variants = {{"particles", "per_pixel"}}, .warm_up = false};
  const auto full = draw(with, o), bare = draw(without_particles(with), o);
  const auto &a = full.downloads.at("particles.radiance"), &b = bare.downloads.at("deferred_lighting.radiance");
  ASSERT_EQ(a.size(), b.size());
  size_t changed = 0;
  for (size_t i = 0; i < a.size(); i += 8) changed += std::memcmp(&a[i], &b[i], 8) != 0;
  EXPECT_GT(changed, 200u);
  EXPECT_LT(changed, a.size() / 8);
}

// Whatever the atlas is stored as, it is seen as that. Of a channel R11G11B10F is 2^-6 off at most (blue), RGB9E5 and
// RGBA16F less; bilinear weights are shares, and colours sum up to the picture: the root mean square of what pictures
// differ by stays below that, halves and all.
TEST(Particles, AnEncodingOfTheirLightIsDrawnAsTheOthers) {
  const auto drawn_with = [](const std::string& encoding) {
    const frame::Options o = {.size = {320, 200},
                              .variants = {{"particles", "bilinear"}, {"particle_light_atlas", encoding}},
                              .shadows = false,
                              .warm_up = false};
    return words<uint16_t>(draw(scene::small(), o).downloads.at("particles.radiance"));
  };
  const auto finest = drawn_with("rgba16f");
  for (const std::string encoding : {"r11g11b10f", "rgb9e5"}) {
    const auto other = drawn_with(encoding);
    ASSERT_EQ(other.size(), finest.size());
    double squares = 0, changed = 0;
    for (size_t i = 0; i < finest.size(); ++i) {
      if (other[i] == finest[i]) continue;
      const double most = half_value(finest[i]), off = (half_value(other[i]) - most) / most;
      squares += off * off, ++changed;
    }
    EXPECT_GT(changed, 200) << encoding << " is another";
    EXPECT_LT(std::sqrt(squares / changed), 0x1p-6) << encoding;
  }
}

}  // namespace
}  // namespace assay::tests
