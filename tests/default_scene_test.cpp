// The built-in scene `default`: that its view holds what the frame of the lit kernels is to be measured on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <set>

#include "harness/formats/visibility.h"
#include "harness/frame/frame.h"
#include "tests/run.h"

namespace assay::tests {
namespace {

using scene::Scene;

constexpr Extent kSize = {1280, 720};

const Scene& hall() {
  static const Scene s = scene::default_scene();
  return s;
}

TEST(DefaultScene, HasWhatItPromises) {
  const Scene& s = hall();
  EXPECT_EQ(s.materials.size(), 60u);
  EXPECT_EQ(s.lights.size(), 300u);
  EXPECT_EQ(s.decals.size(), 1000u);
  EXPECT_EQ(s.particles.size(), 2000u);
  std::set<uint32_t> pictures, receivers;
  for (const scene::Decal& d : s.decals) {
    EXPECT_EQ(fault_of(d, s), "");
    pictures.insert(d.colour_image);
    if (d.receiver != scene::kNone) receivers.insert(d.receiver);
  }
  EXPECT_GE(pictures.size(), 8u);
  EXPECT_GE(receivers.size(), 50u);
  std::array<uint32_t, 3> kinds = {};
  for (const scene::Light& l : s.lights) {
    EXPECT_EQ(fault_of(l), "");
    EXPECT_NEAR(length(l.direction), 1, 1e-5);
    ++kinds[static_cast<size_t>(l.kind)];
  }
  EXPECT_EQ(kinds[0], 1u);
  EXPECT_GE(kinds[1], 100u);
  EXPECT_GE(kinds[2], 100u);
  uint64_t triangles = 0;
  for (const scene::Instance& i : s.instances) triangles += s.meshes[i.mesh].indices.size() / 3;
  fmt::print("{} triangles\n", triangles);
  EXPECT_GE(triangles, 300000u);
  EXPECT_LE(triangles, 1000000u);
  std::set<std::string> names;
  for (const scene::Material& m : s.materials) names.insert(m.name);
  EXPECT_EQ(names.size(), 60u);
  EXPECT_LE(gather(s, default_camera(s), kSize).textures.size(), 4u);
}

TEST(DefaultScene, MaterialsHaveWhatTheirClassSamples) {
  const Scene& s = hall();
  for (const scene::Material& m : s.materials) {
    SCOPED_TRACE(m.name);
    ASSERT_TRUE(m.shader.has_value());
    const uint32_t shader = *m.shader;
    EXPECT_EQ(m.layer != scene::kNone, shader == kShaderTwoLayer);
    EXPECT_EQ(m.mask_image != scene::kNone, shader == kShaderTwoLayer || shader == kShaderSkin || shader == kShaderWet);
    EXPECT_EQ(m.detail_image != scene::kNone, shader == kShaderEmissiveDetail || shader == kShaderCloth);
    EXPECT_EQ(m.emissive_image != scene::kNone, shader == kShaderEmissiveDetail);
    EXPECT_EQ(m.alpha == scene::AlphaMode::masked, shader == kShaderMasked || shader == kShaderFoliage);
    EXPECT_TRUE(m.layer == scene::kNone || m.layer < s.materials.size());
    EXPECT_GT(m.blend_depth, 0);
  }
}

// Byte for byte, in a second at most where this was written (0.3 s); ten are allowed for slower machines and
// sanitizers.
TEST(DefaultScene, IsTheSameEveryTimeAndCheap) {
  const auto begin = std::chrono::steady_clock::now();
  const Scene a = scene::default_scene();
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 10);
  const Scene& b = hall();
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (size_t m = 0; m < a.meshes.size(); ++m) {
    EXPECT_EQ(a.meshes[m].positions, b.meshes[m].positions);
    EXPECT_EQ(a.meshes[m].indices, b.meshes[m].indices);
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (size_t i = 0; i < a.images.size(); ++i) EXPECT_EQ(a.images[i].rgba, b.images[i].rgba);
}

// Normal maps are of unit length within what 8 bits hold.
TEST(DefaultScene, TexturesAreSound) {
  for (const scene::Image& image : hall().images) {
    SCOPED_TRACE(image.name);
    EXPECT_TRUE(image.width == image.height && (image.width == 128 || image.width == 256));
    ASSERT_EQ(image.rgba.size(), size_t{4} * image.width * image.height);
    if (!image.name.ends_with("normal")) continue;
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
      glm::dvec3 n;
      for (int c = 0; c < 3; ++c) n[c] = image.rgba[i + static_cast<size_t>(c)] / 127.5 - 1;
      ASSERT_NEAR(length(n), 1, 1.8 / 255) << i;  // half a code of each component: sqrt(3) / 255
      ASSERT_GT(n.z, 0);
    }
  }
}

TEST(DefaultScene, EachShaderClassCoversTwoPercentOfTheView) {
  const Scene& s = hall();
  const auto camera = default_camera(s);
  const auto gathered = gather(s, camera, kSize);
  EXPECT_EQ(gathered.counts.visible_shaders, kShaderClasses);
  for (uint32_t b = 0; b < kDrawBuckets; ++b)
    EXPECT_GT(gathered.counts.bucket_first[b + 1], gathered.counts.bucket_first[b]) << "bucket " << b;
  const auto r =
      frame::render(*device(), s, camera, {.size = kSize, .goals = {"visibility.visibility"}, .warm_up = false});
  std::vector<uvec2> visibility(pixel_count(kSize));
  std::memcpy(visibility.data(), r.downloads.at("visibility.visibility").data(), visibility.size() * sizeof(uvec2));
  std::array<uint64_t, kShaderClasses> pixels = {};
  std::set<uint32_t> materials;
  std::set<std::pair<uint32_t, uint32_t>> triangles;
  uint64_t nothing = 0;
  for (const uvec2 v : visibility) {
    if (v.y == kVisibilityNone) {
      ++nothing;
      continue;
    }
    const uint32_t surface = v.y & kVisibilitySurfaceMask, material = gathered.surfaces.at(surface).material;
    ++pixels[gathered.materials[material].shader];
    materials.insert(material);
    triangles.emplace(surface, v.x);
  }
  for (uint32_t c = 0; c < kShaderClasses; ++c) {
    const double percent = 100.0 * static_cast<double>(pixels[c]) / static_cast<double>(visibility.size());
    fmt::print("class {}: {:.1f} %\n", c, percent);
    EXPECT_GE(percent, 2) << "class " << c;
  }
  fmt::print("{} materials and {} triangles seen, {} pixels of nothing\n", materials.size(), triangles.size(), nothing);
  EXPECT_EQ(nothing, 0u);  // a hall
  EXPECT_GE(materials.size(), 55u);
  EXPECT_GE(triangles.size(), 50000u);  // columns of triangles of a pixel
}

}  // namespace
}  // namespace assay::tests
