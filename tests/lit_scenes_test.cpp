// The lit frame of whole scenes against the ray caster: what texturing kept of each pixel, and the light it sends.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <glm/gtc/packing.hpp>

#include "harness/frame/frame.h"
#include "harness/scene/gather.h"
#include "tests/reference.h"
#include "tests/run.h"
#include "tests/small_scenes.h"

namespace assay::tests {
namespace {

constexpr Extent kSize = {1280, 720};
constexpr uint32_t kPixels = 1000;
constexpr uint64_t kSeed = 20260102;

struct Lit {
  std::vector<GBufferPixel> textured, gbuffer;  // before and after decals
  std::vector<uint32_t> features;
  std::vector<float> depth;
  std::vector<glm::dvec3> radiance;
};

template <class T>
T value_at(const Bytes& bytes, size_t i) {
  T value;
  std::memcpy(&value, &bytes.at(i * sizeof(T)), sizeof(T));
  return value;
}

std::vector<GBufferPixel> gbuffer_of(const frame::Result& r, const std::string& updated) {
  const std::string texturing = "deferred_texturing.";
  const auto bytes = [&](const std::string& port) -> const Bytes& { return r.downloads.at(port); };
  std::vector<GBufferPixel> pixels;
  for (size_t i = 0; i < pixel_count(kSize); ++i)
    pixels.push_back({value_at<std::array<uint8_t, 4>>(bytes(updated + "base_roughness"), i),
                      value_at<std::array<int16_t, 2>>(bytes(updated + "normal"), i),
                      value_at<std::array<uint8_t, 2>>(bytes(texturing + "metallic_occlusion"), i),
                      value_at<uint32_t>(bytes(texturing + "emissive"), i)});
  return pixels;
}

Lit lit(const scene::Scene& s, const scene::Camera& camera) {
  const std::string texturing = "deferred_texturing.", radiance = "deferred_lighting.radiance";
  const auto draw = [&](const std::string& updated, std::vector<std::string> goals) {
    for (const std::string& port :
         {updated + "base_roughness", updated + "normal", texturing + "metallic_occlusion", texturing + "emissive"})
      goals.push_back(port);
    // Without shadows, which FrameShadows judges.
    return frame::render(*device(), s, camera, {.size = kSize, .shadows = false, .goals = goals, .warm_up = false});
  };
  Lit f;
  const std::string updated = gather(s, camera, kSize).decals.empty() ? texturing : "decal_atlas_sampling.";
  if (updated != texturing) f.textured = gbuffer_of(draw(texturing, {}), texturing);  // decals write over it
  const auto r = draw(updated, {texturing + "features", "visibility.depth", radiance});
  f.gbuffer = gbuffer_of(r, updated);
  if (f.textured.empty()) f.textured = f.gbuffer;
  for (size_t i = 0; i < pixel_count(kSize); ++i) {
    f.features.push_back(value_at<uint32_t>(r.downloads.at(texturing + "features"), i));
    f.depth.push_back(value_at<float>(r.downloads.at("visibility.depth"), i));
    const auto half = value_at<std::array<uint16_t, 4>>(r.downloads.at(radiance), i);
    f.radiance.emplace_back(glm::unpackHalf1x16(half[0]), glm::unpackHalf1x16(half[1]), glm::unpackHalf1x16(half[2]));
  }
  return f;
}

// What the frame's lighting takes for ambient light: read from its parameters.
glm::dvec3 ambient() {
  const Kernel& lighting = kernel_named("deferred_lighting");
  const Case c = lighting.frame({.extent = kSize});
  const auto field = std::ranges::find(lighting.params.fields, "ambient", &Field::name);
  vec3 value;
  std::memcpy(&value, &c.parameters.at(field->offset), sizeof(value));
  return glm::dvec3(value);
}

class LitScenes : public testing::TestWithParam<std::string> {};

scene::Scene scene_of(const std::string& name) {
  for (const std::string& small : small_scene_names())
    if (small == name) return small_scene(name);
  return scene::load(name);
}

// Decals of another scene than was drawn: moved, dropped, painted over, turned, added.
TEST(Decals, OfAnotherSceneAreReported) {
  const scene::Scene s = scene::small();
  const scene::Camera camera = scene::default_camera(s);
  const Lit f = lit(s, camera);
  const auto wrong = [&](const scene::Scene& other) {
    return judge_decals({other, camera, kSize}, f.textured, f.gbuffer, f.depth, 2 * kPixels, kSeed).wrong.size();
  };
  EXPECT_EQ(wrong(s), 0u);
  for (size_t i = 0; i < s.decals.size(); ++i) {
    SCOPED_TRACE(i);
    scene::Scene other = s;
    other.decals[i].centre += mat3_cast(s.decals[i].orientation)[0] * 0.3;
    EXPECT_GT(wrong(other), 0u) << "moved by 30 cm";
    other = s;
    other.decals.erase(other.decals.begin() + static_cast<ptrdiff_t>(i));
    EXPECT_GT(wrong(other), 0u) << "dropped";
    other = s;
    other.decals[i].weights = glm::vec3(1) - other.decals[i].weights;
    EXPECT_GT(wrong(other), 0u) << "other weights";
  }
  scene::Scene other = s;
  other.decals.push_back({.centre = {0, 1, -8}, .half_extents = {1, 1, 0.1}, .colour = {0, 0, 1, 0.5f}});
  EXPECT_GT(wrong(other), 0u) << "added";
}

// As a receiver moves, its decal lies where it lay on it.
TEST(Decals, AreDrawnWhereTheirReceiverIs) {
  scene::Scene s = scene::small();
  const scene::Camera camera = scene::default_camera(s);
  s.instances[s.decals[3].receiver].to_world[3] += glm::dvec4(-0.5, 0.2, 0.4, 0);
  const Lit f = lit(s, camera);
  const Verdict v = judge_decals({s, camera, kSize}, f.textured, f.gbuffer, f.depth, 4 * kPixels, kSeed);
  fmt::print("{}\n", to_text(v));
  EXPECT_TRUE(v.wrong.empty());
  scene::Scene left_behind = s;
  left_behind.decals[3].centre -= glm::dvec3(-0.5, 0.2, 0.4);
  EXPECT_FALSE(
      judge_decals({left_behind, camera, kSize}, f.textured, f.gbuffer, f.depth, 4 * kPixels, kSeed).wrong.empty());
}

TEST_P(LitScenes, AlbedoGeometryAndDirectLightAgree) {
  std::string name = GetParam();
  if (name.ends_with(".glb")) {
    const char* data = std::getenv("ASSAY_DATA");
    name = (std::filesystem::path(data ? data : "../shared/data") / "scenes" / name).string();
    if (!std::filesystem::exists(name))
      GTEST_SKIP() << "no " << name << "; set ASSAY_DATA to the folder that holds scenes/";
  }
  const scene::Scene s = scene_of(name);
  const scene::Camera camera = scene::default_camera(s);
  const Lit f = lit(s, camera);
  const View view = {s, camera, kSize};
  const Verdict surfaces = judge_gbuffer(view, f.textured, kPixels, kSeed);
  fmt::print("G-buffer: {}\n", to_text(surfaces));
  EXPECT_TRUE(surfaces.wrong.empty()) << surfaces.wrong.size() << " pixels, the first: " << surfaces.wrong.front();
  if (!s.decals.empty()) {
    const Verdict decals = judge_decals(view, f.textured, f.gbuffer, f.depth, kPixels, kSeed);
    fmt::print("decals: {}\n", to_text(decals));
    EXPECT_TRUE(decals.wrong.empty()) << decals.wrong.size() << " pixels, the first: " << decals.wrong.front();
    EXPECT_LE(decals.faces, kPixels / 50);
    EXPECT_GE(decals.decaled, kPixels / 50);
  }
  const Verdict light = judge_radiance(view, {f.gbuffer, f.features, f.depth, f.radiance, ambient()},
                                       scene::lights_of(s, camera), kPixels, kSeed);
  fmt::print("light: {}\n", to_text(light));
  EXPECT_TRUE(light.wrong.empty()) << light.wrong.size() << " pixels, the first: " << light.wrong.front();
  EXPECT_GE(light.judged - light.background, kPixels / 50) << "the view shows too little to be a test";
}

std::string as_name(const testing::TestParamInfo<std::string>& info) {
  return info.param.substr(0, info.param.find('.'));
}
std::vector<std::string> scenes() {
  std::vector<std::string> all = small_scene_names();
  for (const char* name : {"bare", "small", "default", "sponza.glb", "flight_helmet.glb", "skull.glb",
                           "two_cylinder_engine.glb", "eztree_grove.glb"})
    all.emplace_back(name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Scenes, LitScenes, testing::ValuesIn(scenes()), as_name);

}  // namespace
}  // namespace assay::tests
