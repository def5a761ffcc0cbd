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
  std::vector<GBufferPixel> gbuffer;
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

Lit lit(const scene::Scene& s, const scene::Camera& camera) {
  const std::string texturing = "deferred_texturing.", radiance = "deferred_lighting.radiance";
  const auto r =
      frame::render(*device(), s, camera,
                    {.size = kSize,
                     .goals = {texturing + "base_roughness", texturing + "normal", texturing + "metallic_occlusion",
                               texturing + "emissive", texturing + "features", "visibility.depth", radiance},
                     .warm_up = false});
  const auto bytes = [&](const char* port) -> const Bytes& { return r.downloads.at(texturing + port); };
  Lit f;
  for (size_t i = 0; i < pixel_count(kSize); ++i) {
    f.gbuffer.push_back({value_at<std::array<uint8_t, 4>>(bytes("base_roughness"), i),
                         value_at<std::array<int16_t, 2>>(bytes("normal"), i),
                         value_at<std::array<uint8_t, 2>>(bytes("metallic_occlusion"), i),
                         value_at<uint32_t>(bytes("emissive"), i)});
    f.features.push_back(value_at<uint32_t>(bytes("features"), i));
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
  const Verdict surfaces = judge_gbuffer(view, f.gbuffer, kPixels, kSeed);
  fmt::print("G-buffer: {}\n", to_text(surfaces));
  EXPECT_TRUE(surfaces.wrong.empty()) << surfaces.wrong.size() << " pixels, the first: " << surfaces.wrong.front();
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
