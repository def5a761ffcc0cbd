// Variable rates in the frame: what they leave alone, what they shade, and what passes from frame to frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "harness/formats/pixel_commands.h"
#include "harness/formats/visibility.h"
#include "harness/formats/vrcs.h"
#include "harness/frame/sequence.h"
#include "harness/oracle.h"
#include "tests/drawn.h"

namespace assay::tests {
namespace {

using frame::Options;
using frame::Result;

const std::string kShown = "vrcs_deblock.deblocked_radiance", kLit = "deferred_lighting.radiance";

// A luma of nothing that is seen: squares of `side` pixels, flat, of noise, and striped either way.
FrameHistory planted(Extent e, uint32_t side) {
  FrameHistory history = {.extent = e, .exposure = 1};
  Pcg32 rng(side);
  for (uint32_t y = 0; y < e.height; ++y)
    for (uint32_t x = 0; x < e.width; ++x) {
      const uint32_t kind = (x / side + 3 * (y / side)) % 4;
      const uint32_t code = kind == 0 ? 90 : kind == 1 ? rng.below(256) : kind == 2 ? x % 2 * 60 : y % 2 * 60;
      for (int channel = 0; channel < 2; ++channel) history.luma.push_back(static_cast<std::byte>(code));
    }
  return history;
}

// Without a picture before, all rates are 1x1: bit for bit what rates that do not vary draw.
TEST(FrameVrcs, FullRatesChangeNothing) {
  for (const scene::Scene& s : {scene::small(), scene::default_scene()}) {
    Options o = {.size = {213, 121}, .warm_up = false};
    for (const std::string vrcs : {"on", "deblocked"}) {
      o.vrcs = "off", o.frame = vrcs == "on" ? 0 : 3;  // which is in the dither between cascades
      const Result off = draw(s, o);
      EXPECT_FALSE(off.downloads.contains(kShown));
      o.vrcs = vrcs;
      const Result r = draw(s, o);
      if (vrcs == "on") {  // else particles are drawn over the deblocked picture
        EXPECT_EQ(r.downloads.at(kLit), off.downloads.at(kLit)) << s.name;
      }
      EXPECT_EQ(r.image.texels, off.image.texels) << s.name << ", " << vrcs;
      EXPECT_EQ(r.downloads.contains(kShown), vrcs == "deblocked");
      if (vrcs == "deblocked") {
        EXPECT_EQ(r.downloads.at(kShown), off.downloads.at(kLit)) << s.name;
      }
      EXPECT_GT(r.vrcs.covered, 0u);
      EXPECT_EQ(r.vrcs.primaries, r.vrcs.covered);
      EXPECT_EQ(r.vrcs.pixels_1x1, r.vrcs.covered);
    }
  }
}

TEST(FrameVrcs, NothingOfItIsThereWithFullRates) {
  const auto e = frame::explain(device::info(*device()), scene::small(), scene::default_camera(scene::small()), {});
  EXPECT_TRUE(std::ranges::none_of(
      e.resources, [](const frame::ResourceNote& r) { return r.bytes > 0 && r.name.starts_with("vrcs"); }));
  EXPECT_TRUE(
      std::ranges::none_of(e.passes, [](const frame::PassNote& p) { return p.runs && p.kernel.starts_with("vrcs"); }));
}

void expect_one_visit(const Result& r) {
  const auto visits = words<uint32_t>(r.downloads.at("vrcs_remap.visits"));
  const auto seen = words<uvec2>(r.downloads.at("visibility.visibility"));
  ASSERT_EQ(visits.size(), seen.size());
  size_t wrong = 0;
  for (size_t i = 0; i < seen.size(); ++i) wrong += visits[i] != (seen[i] != uvec2(kVisibilityNone) ? 1u : 0u);
  EXPECT_EQ(wrong, 0u);
}

// By the rates of any luma, every covered pixel is stored once, shaded or copied, and no other is.
TEST(FrameVrcs, EveryCoveredPixelIsStoredOnce) {
  const scene::Scene s = scene::small();
  for (const Extent size : {Extent{333, 187}, {64, 48}, {1, 1}})
    for (const uint32_t side : {9u, 24u})
      for (const std::string list : {"tile_list", "compact"}) {
        SCOPED_TRACE(list);
        const Result r = draw(s, {.size = size,
                                  .variants = {{"vrcs_coordinates", list},
                                               {"vrcs_remap", list},
                                               {"vrcs_shading_rate", "second_difference_2"}},
                                  .vrcs = "on",
                                  .frame = side,
                                  .history = planted(size, side),
                                  .goals = {"vrcs_remap.visits"},
                                  .warm_up = false});
        expect_one_visit(r);
        if (size.width == 1) continue;
        EXPECT_LT(r.vrcs.primaries, r.vrcs.covered);
        EXPECT_GT(std::min({r.vrcs.pixels_1x2, r.vrcs.pixels_2x1, r.vrcs.pixels_2x2}), 0u);
      }
}

// Copies of an image that a pass wrote by the lists: each duplicate's texel is its primary's, each primary's that of
// full rates. Where `whole_tiles`, tiles with more primaries than a list holds are shaded pixel by pixel.
template <class Texel>
void expect_copies(const std::string& image, bool whole_tiles) {
  const Extent size = {333, 187};
  Options o = {.size = size, .goals = {image, "vrcs_coordinates.copy_bits"}, .warm_up = false};
  o.vrcs = "on", o.history = planted(size, 24);
  const Result r = draw(scene::small(), o);
  const auto copies = words<uint8_t>(r.downloads.at("vrcs_coordinates.copy_bits"));
  const auto tiles = words<uint32_t>(r.downloads.at("vrcs_coordinates.tiles"));
  const auto texels = words<Texel>(r.downloads.at(image));
  o.vrcs = "off", o.goals = {image};
  const auto full = words<Texel>(draw(scene::small(), o).downloads.at(image));
  const uint32_t tiles_across = ceil_div(size.width, kVrcsTileSide);
  uint32_t checked = 0;
  for (uint32_t y = 0; y < size.height; ++y)
    for (uint32_t x = 0; x < size.width; ++x) {
      const size_t at = size_t{y} * size.width + x;
      if (copies[at] & kCopyDuplicate) continue;
      EXPECT_EQ(texels[at], full[at]) << "a primary is shaded as ever";
      const uint32_t tile = tiles[y / kVrcsTileSide * tiles_across + x / kVrcsTileSide];
      if (whole_tiles && (tile & kVrcsTileCount) > kVrcsTileEntries) continue;
      const auto copied = [&](uint32_t bit, uint32_t other_x, uint32_t other_y) {
        if ((copies[at] & bit) == 0) return;
        ASSERT_EQ(texels[size_t{other_y} * size.width + other_x], texels[at]) << x << ", " << y;
        ++checked;
      };
      copied(kCopyHorizontal, x ^ 1, y), copied(kCopyVertical, x, y ^ 1), copied(kCopyDiagonal, x ^ 1, y ^ 1);
    }
  EXPECT_GT(checked, 1000u);
}

TEST(FrameVrcs, TexturingCopiesPrimaries) { expect_copies<uint32_t>("deferred_texturing.normal", false); }
TEST(FrameVrcs, LightingCopiesPrimaries) { expect_copies<uint64_t>(kLit, true); }

TEST(FrameVrcs, AFrameDrawnAloneIsThatOfASequence) {
  const scene::Scene s = scene::small();
  const scene::Camera camera = scene::default_camera(s);
  const Options o = {.size = {320, 180}, .vrcs = "deblocked", .warm_up = false};
  const frame::Drawn three = frame::render_sequence(*device(), s, camera, o, {.frames = 3});
  const frame::Drawn two = frame::render_sequence(*device(), s, camera, o, {.frames = 2});
  ASSERT_EQ(three.frames.size(), 3u);
  for (const uint32_t without_luma : {0u, 1u})
    EXPECT_EQ(three.frames[without_luma].vrcs.primaries, three.frames[without_luma].vrcs.covered);
  EXPECT_LT(three.last.vrcs.primaries, three.last.vrcs.covered);
  EXPECT_NE(three.last.image.texels, two.last.image.texels) << "nothing moves";

  scene::Scene moved = s;
  scene::move_to_frame(9, s, moved);
  scene::move_to_frame(2, s, moved);
  Options alone = o;
  alone.frame = 2, alone.history = two.history;
  const Result r = frame::render(*device(), moved, frame::camera_of({}, camera, 2), alone);
  EXPECT_EQ(r.downloads.at(kShown), three.last.downloads.at(kShown));
  EXPECT_EQ(r.image.texels, three.last.image.texels);
}

TEST(FrameVrcs, ACutAndAnotherSizeBeginAnew) {
  const scene::Scene s = scene::small();
  const scene::Camera camera = scene::default_camera(s);
  Options o = {.size = {160, 90}, .vrcs = "on", .warm_up = false};
  const auto drawn = frame::render_sequence(*device(), s, camera, o, {.frames = 4, .still = true, .cut = 3});
  EXPECT_LT(drawn.frames[2].vrcs.primaries, drawn.frames[2].vrcs.covered);
  EXPECT_EQ(drawn.frames[3].vrcs.primaries, drawn.frames[3].vrcs.covered);
  EXPECT_NE(drawn.last.downloads.at("visibility.visibility"), draw(s, o).downloads.at("visibility.visibility"));

  o.history = planted({90, 160}, 24);
  const frame::VrcsShares shares = draw(s, o).vrcs;
  EXPECT_EQ(shares.primaries, shares.covered);
}

// A picture of fewer pixels than the display's may be coarser, one of as many is finer, and so may its sides.
TEST(FrameVrcs, DynamicResolutionAndBorderChangeWhatPasses) {
  const Extent size = {333, 187};
  const auto primaries = [&](float resolution, uint32_t border) {
    const Options o = {.size = size,
                       .vrcs = "on",
                       .vrcs_resolution = resolution,
                       .vrcs_border = border,
                       .vrcs_tolerance = 0.2f,
                       .history = planted(size, 24),
                       .warm_up = false};
    return draw(scene::small(), o).vrcs.primaries;
  };
  const uint64_t asked = primaries(0, 0);
  EXPECT_LT(primaries(0.5f, 0), asked);
  EXPECT_GT(primaries(1, 0), asked);
  EXPECT_LT(primaries(0, 40), asked);
}

TEST(FrameVrcs, StillFramesShowTheSameScene) {
  const scene::Scene s = scene::small();
  Options o = {.size = {160, 90}, .warm_up = false};
  const auto still = frame::render_sequence(*device(), s, scene::default_camera(s), o, {.frames = 3, .still = true});
  o.frame = 2;  // which is in the dither between cascades
  EXPECT_EQ(still.last.image.texels, draw(s, o).image.texels);
}

TEST(FrameVrcs, ViewsShowRatesAndPrimaries) {
  const scene::Scene s = scene::small();
  const Extent size = {320, 180};
  for (const std::string view : {"rate", "primary"}) {
    Options o = {.size = size, .view = view, .warm_up = false};
    EXPECT_THROW(draw(s, o), std::invalid_argument) << "rates do not vary";
    o.vrcs = "on", o.history = planted(size, 24);
    const Result r = draw(s, o);
    EXPECT_GE(r.legend.size(), 4u);
    const auto texels = words<uint32_t>(r.downloads.at("debug_view.image"));
    EXPECT_GT(std::set<uint32_t>(texels.begin(), texels.end()).size(), 4u);
    EXPECT_GT(r.vrcs.primaries, 0u);
  }
}

TEST(FrameVrcs, UnusableOptionsAreNamed) {
  EXPECT_THROW(draw(scene::bare(), {.size = {8, 8}, .vrcs = "some"}), std::invalid_argument);
  EXPECT_THROW(draw(scene::bare(), {.size = {8, 8}, .vrcs_tolerance = NAN}), std::invalid_argument);
  for (const float share : {-0.1f, 1.1f, NAN})
    EXPECT_THROW(draw(scene::bare(), {.size = {8, 8}, .vrcs_resolution = share}), std::invalid_argument);
  for (const frame::Sequence& wrong : {frame::Sequence{.frames = 0}, {.frames = 3, .cut = 3}, {.frames = 3, .cut = 0}})
    EXPECT_THROW(frame::require(wrong), std::invalid_argument);
}

}  // namespace
}  // namespace assay::tests
