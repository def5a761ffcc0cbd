// The visibility buffer of whole scenes against a ray caster that shares nothing with it but the scene.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "harness/formats/visibility.h"
#include "harness/frame/frame.h"
#include "harness/oracle.h"
#include "tests/raycaster.h"
#include "tests/run.h"
#include "tests/small_scenes.h"

namespace assay::tests {
namespace {

constexpr Extent kSize = {1280, 720};
constexpr uint32_t kPixels = 1000;

std::filesystem::path data_folder() {
  const char* data = std::getenv("ASSAY_DATA");
  return data ? data : "../shared/data";  // tests run in the source folder
}

struct Tally {
  uint32_t judged = 0, background = 0, edges = 0, ties = 0, alpha = 0;
};

uint32_t* count_of(Doubt doubt, Tally& t) {
  switch (doubt) {
    case Doubt::none:
      return nullptr;
    case Doubt::edge:
      return &t.edges;
    case Doubt::alpha:
      return &t.alpha;
    case Doubt::tie:
      return &t.ties;
  }
  return nullptr;
}

Tally compared(const scene::Scene& s, const scene::Camera& camera) {
  Tally t;
  const auto gathered = scene::gather(s, camera, kSize);
  const auto r =
      frame::render(*device(), s, camera, {.size = kSize, .goals = {"visibility.visibility"}, .warm_up = false});
  std::vector<uvec2> visibility(pixel_count(kSize));
  std::memcpy(visibility.data(), r.downloads.at("visibility.visibility").data(), visibility.size() * sizeof(uvec2));
  Pcg32 rng(20260101);
  for (uint32_t i = 0; i < kPixels; ++i) {
    const uint32_t x = rng.below(kSize.width), y = rng.below(kSize.height);
    const auto hit = cast(s, camera, kSize, x + 0.5, y + 0.5);
    if (uint32_t* reason = count_of(doubt_of(hit), t)) {
      ++*reason;
      continue;
    }
    ++t.judged;
    const uvec2 got = visibility[size_t{y} * kSize.width + x];
    if (!hit || hit->instance == scene::kNone) {
      ++t.background;
      EXPECT_EQ(got, uvec2(kVisibilityNone))
          << "pixel " << x << "," << y << " shows a surface where the ray meets none";
      continue;
    }
    const uint32_t surface = got.y & kVisibilitySurfaceMask;
    if (surface >= gathered.surfaces.size()) {
      ADD_FAILURE() << "pixel " << x << "," << y << " shows no surface of the scene's, but the ray meets one";
      continue;
    }
    EXPECT_EQ(gathered.surface_instance[surface], hit->instance)
        << "pixel " << x << "," << y << ", " << hit->distance << " m away";
    EXPECT_EQ(gathered.surface_part[surface], hit->part) << "pixel " << x << "," << y;
    EXPECT_EQ(got.x, hit->triangle) << "pixel " << x << "," << y << ", edge " << hit->edge_px << " px away";
  }
  fmt::print("{} judged ({} background), not judged: {} at an edge, {} at an alpha cut, {} ties\n", t.judged,
             t.background, t.edges, t.alpha, t.ties);
  // Triangles of about a pixel have an edge within 1/128 px of one pixel in twenty; foliage is mostly alpha cuts.
  EXPECT_LE(t.edges, kPixels / 10);
  EXPECT_LE(t.ties, kPixels / 50);
  EXPECT_LE(t.alpha, kPixels * 3 / 4);
  return t;
}

class Raycast : public testing::TestWithParam<const char*> {};

TEST_P(Raycast, TrianglesAndInstancesAgree) {
  std::string name = GetParam();
  if (name.ends_with(".glb")) {
    name = (data_folder() / "scenes" / name).string();
    if (!std::filesystem::exists(name))
      GTEST_SKIP() << "no " << name << "; set ASSAY_DATA to the folder that holds scenes/";
  }
  const scene::Scene s = std::ranges::count(small_scene_names(), name) ? small_scene(name) : scene::load(name);
  scene::Camera camera = scene::default_camera(s);
  const Tally whole = compared(s, camera);
  EXPECT_GE(whole.judged - whole.background, kPixels / 50) << "the view shows too little to be a test";
  if (whole.background * 2 < kPixels) return;
  camera.vertical_fov_rad /= 3;  // mostly background: closer too
  EXPECT_GE(compared(s, camera).judged, kPixels / 4);
}

std::string as_name(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  return name.substr(0, name.find('.'));
}
INSTANTIATE_TEST_SUITE_P(Scenes, Raycast,
                         testing::Values("bare", "small", "default", "masked", "double_sided", "tangentless", "uvless",
                                         "textureless", "sponza.glb", "flight_helmet.glb", "skull.glb",
                                         "two_cylinder_engine.glb", "eztree_grove.glb"),
                         as_name);

}  // namespace
}  // namespace assay::tests
