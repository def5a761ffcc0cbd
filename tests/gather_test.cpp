// The buffers of a view: records, draws, culling, textures.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "harness/scene/scene.h"

namespace assay::tests {
namespace {

using scene::Gathered;
using scene::Scene;

constexpr Extent kExtent = {640, 360};

void expect_sound(const Scene& s, const Gathered& g) {
  ASSERT_EQ(g.counts.surfaces, g.surfaces.size());
  ASSERT_EQ(g.counts.draws, g.draws.size());
  ASSERT_EQ(g.counts.vertices, g.positions.size());
  ASSERT_EQ(g.counts.indices, g.indices.size());
  ASSERT_EQ(g.counts.materials, g.materials.size());
  ASSERT_EQ(g.positions.size(), g.attributes.size());
  EXPECT_EQ(g.counts.bucket_first[0], 0u);
  EXPECT_EQ(g.counts.bucket_first[kDrawBuckets], g.counts.draws);
  uint32_t next = 0;
  for (uint32_t bucket = 0; bucket < kDrawBuckets; ++bucket)
    for (uint32_t d = g.counts.bucket_first[bucket]; d < g.counts.bucket_first[bucket + 1]; ++d) {
      const DrawCommand& draw = g.draws[d];
      EXPECT_EQ(draw.first_instance, next);
      for (uint32_t i = next; i < next + draw.instance_count; ++i) {
        const SurfaceRecord& r = g.surfaces[i];
        const scene::Instance& instance = s.instances[g.surface_instance[i]];
        const scene::Part& part = s.meshes[instance.mesh].parts[g.surface_part[i]];
        EXPECT_EQ(r.material, part.material);
        EXPECT_EQ(r.mesh, instance.mesh);
        EXPECT_EQ(r.first_index, draw.first_index);
        EXPECT_EQ(r.vertex_offset, draw.vertex_offset);
        EXPECT_EQ(r.triangle_count * 3, draw.index_count);
        const bool flipped = determinant(instance.to_world) < 0, both = s.materials[part.material].double_sided;
        EXPECT_EQ((r.flags & kSurfaceFlipped) != 0, flipped);
        EXPECT_EQ((r.flags & kSurfaceInstanced) != 0, draw.instance_count > 1);
        EXPECT_EQ(bucket % 3, both ? kFacingBoth : flipped ? kFacingCullFront : kFacingCullBack);
        EXPECT_EQ(bucket / 3, s.materials[part.material].alpha == scene::AlphaMode::masked ? 1u : 0u);
        for (uint32_t k = 0; k < draw.index_count; ++k)
          ASSERT_EQ(g.positions[g.indices[r.first_index + k] + r.vertex_offset],
                    s.meshes[instance.mesh].positions[s.meshes[instance.mesh].indices[part.first_index + k]]);
      }
      next += draw.instance_count;
    }
  EXPECT_EQ(next, g.counts.surfaces);
}

TEST(Gather, BareIsOneDrawWithoutTextures) {
  const Scene s = scene::bare();
  const Gathered g = gather(s, default_camera(s), kExtent);
  expect_sound(s, g);
  EXPECT_EQ(g.counts.surfaces, 1u);
  EXPECT_EQ(g.counts.draws, 1u);
  EXPECT_EQ(g.counts.vertices, 3u);
  EXPECT_TRUE(g.textures.empty());
  EXPECT_EQ(g.materials[0].base_texture, kNoTexture);
  EXPECT_EQ(g.materials[0].layer, kNoMaterial);
  EXPECT_EQ(g.shaders, std::vector<uint32_t>{kShaderOpaque});
  EXPECT_EQ(g.counts.visible_materials, 1u);
  ASSERT_EQ(g.surface_slots.size(), 1u);
  EXPECT_EQ(g.surface_slots[0].shader + g.surface_slots[0].material, 0u);
}

TEST(Gather, SmallFillsEveryBucketAndInstances) {
  const Scene s = scene::small();
  const Gathered g = gather(s, default_camera(s), kExtent);
  expect_sound(s, g);
  for (uint32_t b = 0; b < kDrawBuckets; ++b)
    EXPECT_GT(g.counts.bucket_first[b + 1], g.counts.bucket_first[b]) << "bucket " << b;
  EXPECT_TRUE(std::any_of(g.draws.begin(), g.draws.end(), [](const DrawCommand& d) { return d.instance_count >= 8; }));
  EXPECT_EQ(g.textures.size(), 2u);
}

// Compact numbers run without gaps, ascend with what they number, and belong to the surface's own material.
TEST(Gather, SlotsNumberWhatIsVisible) {
  Scene s = scene::small();
  s.materials.insert(s.materials.begin(), {.name = "nobody's", .shader = kShaderSkin});
  for (scene::Mesh& m : s.meshes)
    for (scene::Part& part : m.parts) ++part.material;
  const Gathered g = gather(s, default_camera(s), kExtent);
  ASSERT_EQ(g.surface_slots.size(), g.surfaces.size());
  EXPECT_EQ(g.counts.visible_shaders, g.shaders.size());
  EXPECT_TRUE(std::is_sorted(g.shaders.begin(), g.shaders.end()));
  std::set<uint32_t> visible, classes;
  for (const SurfaceRecord& r : g.surfaces) visible.insert(r.material), classes.insert(g.materials[r.material].shader);
  EXPECT_EQ(g.shaders, std::vector<uint32_t>(classes.begin(), classes.end()));
  EXPECT_EQ(g.counts.visible_materials, visible.size());
  const std::vector<uint32_t> ordered(visible.begin(), visible.end());
  for (size_t i = 0; i < g.surfaces.size(); ++i) {
    ASSERT_LT(g.surface_slots[i].shader, g.shaders.size());
    ASSERT_LT(g.surface_slots[i].material, ordered.size());
    EXPECT_EQ(g.shaders[g.surface_slots[i].shader], g.materials[g.surfaces[i].material].shader);
    EXPECT_EQ(ordered[g.surface_slots[i].material], g.surfaces[i].material);
  }
  EXPECT_GE(g.shaders.size(), 4u);
  EXPECT_EQ(std::count(g.shaders.begin(), g.shaders.end(), kShaderSkin), 0);
}

// Rays and depth lead back to the point that was projected: each component's error is a rounding of each of the three
// vectors' entries, weighted by w and the pixel.
TEST(Gather, RaysInvertTheProjection) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-100000, 100000), [](int i) { return i * 0.001; });
  const bool passed = rc::check("rays", [&] {
    const Extent extent = {*rc::gen::inRange(1u, 4000u), *rc::gen::inRange(1u, 4000u)};
    const glm::dvec3 eye(*coordinate, *coordinate, *coordinate), target(*coordinate, *coordinate, *coordinate);
    const glm::dvec3 point(*coordinate, *coordinate, *coordinate);
    RC_PRE(length(eye - target) > 0.5);
    const scene::Camera camera = scene::look_at(eye, target, 0.8);
    const scene::ClipRows rows = clip_rows(camera, extent);
    const glm::dvec3 relative = point - eye;
    const double w = dot(glm::dvec3(rows.w), relative);
    RC_PRE(w > 0.1);
    const double x = (dot(glm::dvec3(rows.x), relative) / w + 1) / 2 * extent.width,
                 y = (dot(glm::dvec3(rows.y), relative) / w + 1) / 2 * extent.height;
    const ViewRays rays = view_rays(camera, extent);
    const glm::dvec3 corner(rays.corner), across(rays.across), down(rays.down);
    const glm::dvec3 got = w * (corner + across * x + down * y);
    const glm::dvec3 size = w * (abs(corner) + abs(across * x) + abs(down * y));
    for (int c = 0; c < 3; ++c)
      RC_ASSERT(std::abs(got[c] - relative[c]) <= size[c] * std::ldexp(1.0, -24) + 1e-9 * length(relative));
  });
  EXPECT_TRUE(passed);
}

// Rows are the double product rounded once: each float within half an ulp of the product formed here anew.
TEST(Gather, RowsAreRoundedOnce) {
  Scene s = scene::bare();
  const auto coordinate = rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int i) { return i * 1.0; });
  const bool passed = rc::check("rows", [&] {
    const glm::dvec3 at(*coordinate, *coordinate, *coordinate);
    s.instances[0].to_world[3] = glm::dvec4(at, 1);
    const scene::Camera camera = scene::look_at(at + glm::dvec3(0.25, 0.5, 3), at, 0.8);
    const Gathered g = gather(s, camera, kExtent);
    RC_ASSERT(g.surfaces.size() == 1u);
    const scene::ClipRows rows = clip_rows(camera, kExtent);
    const glm::dvec3 relative = at - camera.eye;
    const double w = rows.w.x * relative.x + rows.w.y * relative.y + rows.w.z * relative.z;
    RC_ASSERT(std::abs(g.surfaces[0].clip_w.w - w) <= std::abs(w) * std::ldexp(1.0, -24) + 1e-12);
    RC_ASSERT(g.surfaces[0].world_x.w == static_cast<float>(relative.x));
    RC_ASSERT(g.surfaces[0].clip_x.x == static_cast<float>(rows.x.x));
  });
  EXPECT_TRUE(passed);
}

// Nothing that a pixel could show is culled, and what lies wholly beyond a plane is.
TEST(Gather, CullingKeepsEverythingInView) {
  const Scene s = scene::small();
  const auto coordinate = rc::gen::map(rc::gen::inRange(-1000, 1000), [](int i) { return i * 0.01; });
  const bool passed = rc::check("culling", [&] {
    const glm::dvec3 eye(*coordinate, *coordinate, *coordinate), target(*coordinate, *coordinate, *coordinate);
    RC_PRE(length(eye - target) > 0.1);
    const scene::Camera camera = scene::look_at(eye, target, 0.8);
    const Gathered g = gather(s, camera, kExtent);
    std::set<uint32_t> kept(g.surface_instance.begin(), g.surface_instance.end());
    const scene::ClipRows rows = clip_rows(camera, kExtent);
    for (uint32_t i = 0; i < s.instances.size(); ++i)
      for (const glm::vec3& p : s.meshes[s.instances[i].mesh].positions) {
        const glm::dvec4 world = s.instances[i].to_world * glm::dvec4(p, 1) - glm::dvec4(camera.eye, 0);
        const double x = dot(rows.x, world), y = dot(rows.y, world), w = dot(rows.w, world);
        if (w > camera.near_plane && std::abs(x) <= w && std::abs(y) <= w) RC_ASSERT(kept.count(i) == 1);
      }
  });
  EXPECT_TRUE(passed);
}

TEST(Gather, LookingAwayGathersNothing) {
  const Scene s = scene::small();
  const Gathered g = gather(s, scene::look_at({0, 2, 20}, {0, 2, 40}, 0.8), kExtent);
  EXPECT_EQ(g.counts.surfaces + g.counts.vertices + g.counts.indices + g.counts.draws, 0u);
  EXPECT_TRUE(g.textures.empty());
  EXPECT_TRUE(g.shaders.empty());
  EXPECT_TRUE(g.surface_slots.empty());
  EXPECT_TRUE(g.decals.empty());
  EXPECT_TRUE(g.receivers.empty());
  EXPECT_TRUE(g.decal_atlas.empty());
  ASSERT_EQ(g.notes.size(), 4u);
  EXPECT_NE(g.notes[0].find("42 of 42"), std::string::npos) << g.notes[0];
  EXPECT_NE(g.notes[1].find("2 of 3 lights"), std::string::npos) << g.notes[1];
  EXPECT_NE(g.notes[2].find("48 of 48 particles"), std::string::npos) << g.notes[2];
  EXPECT_NE(g.notes[3].find("4 of 4 decals"), std::string::npos) << g.notes[3];
}

TEST(Gather, BlendedMaterialsAreLeftOutWithANote) {
  Scene s = scene::bare();
  s.materials[0].alpha = scene::AlphaMode::blended;
  const Gathered g = gather(s, default_camera(s), kExtent);
  EXPECT_EQ(g.counts.surfaces, 0u);
  ASSERT_EQ(g.notes.size(), 2u);  // the other is about the default light
  EXPECT_NE(g.notes[0].find("blended"), std::string::npos);
}

// ---- Materials and textures
// ------------------------------------------------------------------------------------------------------

Scene textured(std::vector<scene::Image> images) {
  Scene s = scene::bare();
  s.images = std::move(images);
  s.materials.clear();
  s.meshes[0].parts.clear();
  for (uint32_t i = 0; i < s.images.size(); ++i) {
    s.materials.push_back({.base_image = i});
    s.meshes[0].parts.push_back({0, 3, i});
  }
  return s;
}
scene::Image flat(uint32_t width, uint32_t height, uint8_t value) {
  return {"flat", width, height, std::vector<uint8_t>(size_t{width} * height * 4, value)};
}

TEST(Gather, MaterialRecordsAreWhole) {
  Scene s = textured({});
  for (uint32_t i = 0; i < 7; ++i) s.images.push_back(flat(4, 4, static_cast<uint8_t>(i)));
  s.materials = {{.name = "all",
                  .base_colour = {0.1f, 0.2f, 0.3f, 0.4f},
                  .metallic = 0.5f,
                  .roughness = 0.6f,
                  .emissive = {7, 8, 9},
                  .base_image = 0,
                  .normal_image = 1,
                  .metallic_roughness_image = 2,
                  .occlusion_image = 3,
                  .emissive_image = 4,
                  .alpha = scene::AlphaMode::masked,
                  .alpha_cutoff = 0.7f,
                  .double_sided = true,
                  .features = kFeatureSkin,
                  .normal_scale = 0.8f,
                  .occlusion_strength = 0.9f,
                  .shader = kShaderTwoLayer,
                  .layer = 1,
                  .mask_image = 5,
                  .blend_depth = 0.25f,
                  .detail_image = 6,
                  .detail_scale = 11},
                 {.name = "on top", .normal_image = 6},
                 {.name = "unseen", .base_image = 2}};
  s.meshes[0].parts = {{0, 3, 0}};
  const Gathered g = gather(s, default_camera(s), kExtent);
  ASSERT_EQ(g.textures.size(), 2u);
  const auto value = [&](uint32_t name, Format format) {  // of the layer's first texel, which names its image
    EXPECT_NE(name, kNoTexture);
    const Texture& t = g.textures[name >> 16];
    EXPECT_EQ(t.format, format);
    return static_cast<int>(t.bytes[size_t{name & 0xffffu} * 64]);
  };
  const MaterialRecord& m = g.materials[0];
  EXPECT_EQ(m.base_colour, vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(value(m.base_texture, Format::rgba8_srgb), 0);
  EXPECT_EQ(value(m.normal_texture, Format::rgba8_unorm), 1);
  EXPECT_EQ(value(m.metallic_roughness_texture, Format::rgba8_unorm), 2);
  EXPECT_EQ(value(m.occlusion_texture, Format::rgba8_unorm), 3);
  EXPECT_EQ(value(m.emissive_texture, Format::rgba8_srgb), 4);
  EXPECT_EQ(value(m.mask_texture, Format::rgba8_unorm), 5);
  EXPECT_EQ(value(m.detail_texture, Format::rgba8_unorm), 6);
  EXPECT_EQ(m.emissive, vec3(7, 8, 9));
  for (const auto& [got, expected] :
       {std::pair{m.alpha_cutoff, 0.7f}, std::pair{m.metallic, 0.5f}, std::pair{m.roughness, 0.6f},
        std::pair{m.normal_scale, 0.8f}, std::pair{m.occlusion_strength, 0.9f}, std::pair{m.blend_depth, 0.25f},
        std::pair{m.detail_scale, 11.0f}})
    EXPECT_EQ(got, expected);
  EXPECT_EQ(m.flags, kMaterialMasked | kMaterialDoubleSided);
  EXPECT_EQ(m.features,
            kFeatureOpaque | kFeatureMasked | kFeatureDoubleSided | kFeatureSkin | kFeatureEmissive | kFeatureTextured);
  EXPECT_EQ(m.shader, kShaderTwoLayer);
  EXPECT_EQ(m.layer, 1u);
  EXPECT_EQ(g.materials[1].normal_texture, m.detail_texture);  // the layer on top is sampled, so its image is there
  EXPECT_EQ(g.materials[2].base_texture, kNoTexture);
  EXPECT_EQ(g.counts.visible_materials, 1u);
}

TEST(Gather, AnImageReadBothWaysIsThereTwice) {
  Scene s = textured({flat(4, 4, 90)});
  s.materials[0].occlusion_image = s.materials[0].emissive_image = s.materials[0].metallic_roughness_image = 0;
  const Gathered g = gather(s, default_camera(s), kExtent);
  ASSERT_EQ(g.textures.size(), 2u);
  EXPECT_EQ(g.textures[0].layers + g.textures[1].layers, 2u);
  const MaterialRecord& m = g.materials[0];
  EXPECT_EQ(m.base_texture, m.emissive_texture);
  EXPECT_EQ(m.occlusion_texture, m.metallic_roughness_texture);
  EXPECT_NE(m.base_texture, m.occlusion_texture);
}

TEST(Gather, OneArrayASizeAndNamesThatFindTheLayer) {
  const Scene s = textured({flat(4, 4, 10), flat(8, 2, 20), flat(4, 4, 30)});
  const Gathered g = gather(s, default_camera(s), kExtent);
  ASSERT_EQ(g.textures.size(), 2u);
  EXPECT_EQ(g.textures[0].layers, 2u);
  EXPECT_EQ(g.textures[0].levels, 3u);
  EXPECT_EQ(g.textures[1].levels, 4u);
  EXPECT_EQ(g.textures[1].bytes.size(), 4u * (16 + 4 + 2 + 1));
  EXPECT_EQ(g.materials[0].base_texture, 0u);
  EXPECT_EQ(g.materials[1].base_texture, 1u << 16);
  EXPECT_EQ(g.materials[2].base_texture, 1u);
  EXPECT_EQ(static_cast<int>(g.textures[0].bytes[size_t{4} * 16]), 30);  // second layer's first texel
}

TEST(Gather, MipsAverageInLinearLight) {
  scene::Image checks = flat(2, 2, 255);
  for (const size_t texel : {size_t{0}, size_t{3}})
    for (size_t c = 0; c < 3; ++c) checks.rgba[texel * 4 + c] = 0;
  checks.rgba[3] = 0;  // alpha is no light: (0 + 3 * 255) / 4 = 191.25
  const Scene s = textured({checks});
  const Gathered g = gather(s, default_camera(s), kExtent);
  EXPECT_EQ(static_cast<int>(g.textures[0].bytes[16]), 188);  // sRGB of one half
  EXPECT_EQ(static_cast<int>(g.textures[0].bytes[19]), 191);
}

TEST(Gather, MipsOfNumbersAverageThem) {
  scene::Image checks = flat(2, 2, 255);
  for (const size_t texel : {size_t{0}, size_t{3}})
    for (size_t c = 0; c < 3; ++c) checks.rgba[texel * 4 + c] = 0;
  Scene s = textured({checks});
  std::swap(s.materials[0].base_image, s.materials[0].normal_image);
  const Gathered g = gather(s, default_camera(s), kExtent);
  EXPECT_EQ(g.textures[0].format, Format::rgba8_unorm);
  EXPECT_EQ(static_cast<int>(g.textures[0].bytes[16]), 128);  // of 127.5
}

TEST(Gather, MipsOfOddSizesWeighEveryTexel) {
  scene::Image stripe = flat(3, 1, 0);
  for (const size_t texel : {size_t{0}, size_t{2}}) stripe.rgba[texel * 4 + 3] = 240;
  const Scene s = textured({stripe});
  const Gathered g = gather(s, default_camera(s), kExtent);
  EXPECT_EQ(g.textures[0].levels, 2u);
  EXPECT_EQ(static_cast<int>(g.textures[0].bytes[12 + 3]), 160);  // 480 / 3
}

TEST(Gather, MipsOfAFlatImageStayFlat) {
  const bool passed = rc::check("flat mips", [&] {
    const auto value = *rc::gen::arbitrary<uint8_t>();
    const Scene s = textured({flat(*rc::gen::inRange(1u, 30u), *rc::gen::inRange(1u, 30u), value)});
    const Gathered g = gather(s, default_camera(s), kExtent);
    for (const std::byte b : g.textures[0].bytes) RC_ASSERT(static_cast<uint8_t>(b) == value);
  });
  EXPECT_TRUE(passed);
}

TEST(Gather, MoreThanSixteenArraysAreRefusedInOneLine) {
  std::vector<scene::Image> images;
  for (uint32_t i = 1; i <= 17; ++i) images.push_back(flat(i, 1, 0));
  const Scene s = textured(images);
  try {
    gather(s, default_camera(s), kExtent);
    FAIL() << "accepted";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("17 array textures"), std::string::npos) << e.what();
  }
  images.pop_back();
  Scene enough = textured(images);
  EXPECT_EQ(gather(enough, default_camera(enough), kExtent).textures.size(), 16u);
  enough.materials[3].mask_image = 0;  // the 17th: a size that is there, read as numbers
  EXPECT_THROW(gather(enough, default_camera(enough), kExtent), std::runtime_error);
}

}  // namespace
}  // namespace assay::tests
