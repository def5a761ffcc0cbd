// The study of particles' light says what it measured: the order of errors that filters must have, and planted fronts.
#include "harness/study/particle_light.h"

#include <gtest/gtest.h>

#include "tests/run.h"

namespace assay::tests {
namespace {

using namespace study;

void untold(const std::string&, uint64_t, uint64_t) {}

const std::vector<ParticleOutcome>& measured() {
  static const auto outcomes = try_all(
      *device(), {.encodings = {"r11g11b10f", "rgba16f"}, .sides = {8, 32}, .lights = 1, .layers = 1, .samples = 1},
      untold);
  return outcomes;
}
double rms_of(const std::string& input_class, const std::string& way) {
  for (const ParticleOutcome& o : measured())
    if (o.input_class == input_class && label_of(o.way) == way) return o.rms;
  ADD_FAILURE() << input_class << ": no " << way;
  return NAN;
}

TEST(ParticleLightStudy, EveryWayHasAnErrorAndATime) {
  // Three filters by two encodings by two sides in three classes; corners and pixels in those without a shadow.
  EXPECT_EQ(measured().size(), 3u * 2 * 2 * 3 + 2 * 2);
  for (const ParticleOutcome& o : measured()) {
    EXPECT_GT(o.rms, 0) << label_of(o.way);
    EXPECT_GT(o.most, o.rms) << label_of(o.way);
    EXPECT_GT(o.draw_ns, 0) << label_of(o.way);
    EXPECT_EQ(o.light_ns > 0, o.way.side > 0) << label_of(o.way);
    EXPECT_EQ(o.is_default, o.way.filter == "catmull_rom" && o.way.encoding == "r11g11b10f") << label_of(o.way);
  }
}

TEST(ParticleLightStudy, LightAtEveryPixelErrsLeast) {
  for (const char* c : {"smooth light", "close light"})
    for (const ParticleOutcome& o : measured()) {
      if (o.input_class != c || o.way.filter == "per_pixel") continue;
      EXPECT_LT(rms_of(c, "per_pixel"), o.rms) << c << ", " << label_of(o.way);
    }
}

TEST(ParticleLightStudy, MoreTexelsErrLessAndCornersMost) {
  for (const std::string c : {"smooth light", "close light"})
    for (const std::string filter : {"bilinear", "b_spline", "catmull_rom"}) {
      EXPECT_LT(rms_of(c, filter + ", 32 rgba16f"), rms_of(c, filter + ", 8 rgba16f")) << c << ", " << filter;
      EXPECT_LT(rms_of(c, filter + ", 8 rgba16f"), rms_of(c, "per_vertex")) << c << ", " << filter;
    }
  EXPECT_LT(rms_of("smooth light", "catmull_rom, 8 rgba16f"), rms_of("smooth light", "bilinear, 8 rgba16f"));
  EXPECT_LT(rms_of("smooth light", "catmull_rom, 32 rgba16f"), rms_of("smooth light", "catmull_rom, 32 r11g11b10f"))
      << "there codes are what is left of the error";
}

ParticleOutcome planted(const std::string& input_class, double rms, double draw_ns, double light_ns) {
  return {.input_class = input_class, .way = {}, .rms = rms, .draw_ns = draw_ns, .light_ns = light_ns};
}

TEST(ParticleLightStudy, TheFrontIsWhatNothingBeats) {
  std::vector<ParticleOutcome> all = {planted("a", 0.1, 5, 5),  planted("a", 0.2, 5, 5), planted("a", 0.2, 5, 4),
                                      planted("a", 0.1, 10, 0), planted("a", NAN, 1, 1), planted("b", 0.3, 9, 9)};
  mark_front(all);
  std::vector<bool> front;
  for (const ParticleOutcome& o : all) front.push_back(o.in_front);
  EXPECT_EQ(front, (std::vector<bool>{true, false, true, true, false, true}));
  EXPECT_EQ(table_of(all, "a", false).rows.size(), 3u);
  EXPECT_EQ(table_of(all, "a", true).rows.size(), 5u);
}

TEST(ParticleLightStudy, LargerFramesWantNoFewerTexels) {
  const auto frames = at_sizes(*device(), scene::small(), {{160, 90}, {1280, 720}}, 1, untold);
  ASSERT_EQ(frames.size(), 2u);
  for (const ParticleFrame& f : frames) {
    EXPECT_GT(f.lit, 0u);
    EXPECT_GE(f.texels, f.lit * 64);
    EXPECT_LE(f.texels, f.lit * 1024);
    EXPECT_GT(f.rects_ns, 0);
    EXPECT_GT(f.light_ns, 0);
    EXPECT_GT(f.draw_ns, 0);
  }
  EXPECT_EQ(frames[0].texels, frames[0].lit * 64) << "none is 64 pixels wide";
  EXPECT_GT(frames[1].texels, frames[0].texels);
}

}  // namespace
}  // namespace assay::tests
